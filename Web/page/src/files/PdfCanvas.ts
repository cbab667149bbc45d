// SPDX-License-Identifier: BSD-3-Clause
import {
  appendBezierCurve, beginText, clip, closePath, concatTransformationMatrix, drawObject, endPath, endText, fillAndStroke, lineTo, moveTo, PDFDocument,
  popGraphicsState, pushGraphicsState, rectangle, setDashPattern, setFillingRgbColor, setFontAndSize, setLineWidth, setStrokingRgbColor,
  setTextMatrix, showText, StandardFonts, stroke, type PDFContext, type PDFFont, type PDFName, type PDFOperator, type PDFPage,
} from "pdf-lib";
import type { PageCanvas } from "surfaceflattening";

const pointsPerMillimeter = 72 / 25.4;

/** Pages of a PDF at true scale, by pdf-lib. */
export class PdfCanvas implements PageCanvas {
  private page!: PDFPage;
  private fontName!: PDFName;
  private operators: PDFOperator[] = [];
  private readonly letters: Set<number>;

  private constructor(private readonly file: PDFDocument, private readonly font: PDFFont) {
    this.letters = new Set(font.getCharacterSet());
  }

  static async create(title: string): Promise<PdfCanvas> {
    const file = await PDFDocument.create();
    file.setTitle(title);
    file.setCreator("SurfaceFlattening");
    return new PdfCanvas(file, await file.embedFont(StandardFonts.Helvetica));
  }

  bytes(): Promise<Uint8Array> {
    return this.file.save();
  }

  beginPage(width: number, height: number): void {
    this.page = this.file.addPage([width * pointsPerMillimeter, height * pointsPerMillimeter]);
    this.page.setFont(this.font);
    this.fontName = this.page.node.newFontDictionary(this.font.name, this.font.ref);
    const scale = pointsPerMillimeter;
    this.operators = [pushGraphicsState(), concatTransformationMatrix(scale, 0, 0, -scale, 0, height * scale)];
  }

  endPage(): void {
    this.page.pushOperators(...this.operators, popGraphicsState());
  }

  save(): void {
    this.operators.push(pushGraphicsState());
  }

  restore(): void {
    this.operators.push(popGraphicsState());
  }

  translate(x: number, y: number): void {
    this.operators.push(concatTransformationMatrix(1, 0, 0, 1, x, y));
  }

  scale(factor: number): void {
    this.operators.push(concatTransformationMatrix(factor, 0, 0, factor, 0, 0));
  }

  clip(x: number, y: number, width: number, height: number): void {
    this.operators.push(rectangle(x, y, width, height), clip(), endPath());
  }

  pen(red: number, green: number, blue: number, width: number, dashes: number[]): void {
    this.operators.push(setStrokingRgbColor(red, green, blue), setFillingRgbColor(red, green, blue), setLineWidth(width), setDashPattern(dashes, 0));
  }

  moveTo(x: number, y: number): void {
    this.operators.push(moveTo(x, y));
  }

  lineTo(x: number, y: number): void {
    this.operators.push(lineTo(x, y));
  }

  curveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number): void {
    this.operators.push(appendBezierCurve(x1, y1, x2, y2, x, y));
  }

  rectangle(x: number, y: number, width: number, height: number): void {
    this.operators.push(rectangle(x, y, width, height));
  }

  closePath(): void {
    this.operators.push(closePath());
  }

  stroke(isFilled: boolean): void {
    this.operators.push(isFilled ? fillAndStroke() : stroke());
  }

  text(words: string, x: number, y: number, height: number, anchor: number, angle: number): void {
    const isKnown = Array.from(words).every((letter) => this.letters.has(letter.codePointAt(0) ?? 0));
    const drawn = isKnown ? null : pictureOf(words, height);
    const back = anchor * (drawn?.width ?? this.font.widthOfTextAtSize(words, height));
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    // y is downward, and letters stand upright in it; the baseline lies below the middle of their height.
    const below = 0.35 * height + (drawn?.descent ?? 0);
    const [left, bottom] = [x - back * cos + below * sin, y + back * sin + below * cos];
    if (drawn) {
      const image = this.page.node.newXObject("Words", this.file.context.register(drawn.stream(this.file.context)));
      this.operators.push(pushGraphicsState(),
        concatTransformationMatrix(drawn.width * cos, -drawn.width * sin, -drawn.height * sin, -drawn.height * cos, left, bottom),
        drawObject(image), popGraphicsState());
    } else {
      this.operators.push(beginText(), setFontAndSize(this.fontName, height),
        setTextMatrix(cos, -sin, -sin, -cos, left, bottom), showText(this.font.encodeText(words)), endText());
    }
  }
}

/** Words in letters that fonts of PDF readers lack, by a font of the browser, as a mask that is painted in the pen's color. */
function pictureOf(words: string, size: number) {
  const pixels = 24; // a millimeter: 610 an inch
  const font = `${size * pixels}px Helvetica, Arial, sans-serif`;
  const context = new OffscreenCanvas(1, 1).getContext("2d") as OffscreenCanvasRenderingContext2D;
  context.font = font;
  const { canvas } = context;
  canvas.width = 8 * Math.ceil(context.measureText(words).width / 8);
  canvas.height = Math.ceil(1.6 * size * pixels);
  context.font = font; // a new size resets it
  context.fillText(words, 0, 1.15 * size * pixels);
  const { width, height, data } = context.getImageData(0, 0, canvas.width, canvas.height);
  const bits = new Uint8Array(data.length / 32);
  for (let k = 0; 4 * k < data.length; ++k) {
    bits[k >> 3] |= data[4 * k + 3] > 127 ? 128 >> k % 8 : 0;
  }
  const header = { Type: "XObject", Subtype: "Image", Width: width, Height: height, ImageMask: true, Decode: [1, 0], BitsPerComponent: 1 };
  return {
    width: width / pixels, height: height / pixels, descent: height / pixels - 1.15 * size,
    stream: (file: PDFContext) => file.flateStream(bits, header),
  };
}
