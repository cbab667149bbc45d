// SPDX-License-Identifier: BSD-3-Clause
import {
  appendBezierCurve, beginText, clip, closePath, concatTransformationMatrix, endPath, endText, fillAndStroke, lineTo, moveTo, PDFDocument,
  popGraphicsState, pushGraphicsState, rectangle, setDashPattern, setFillingRgbColor, setFontAndSize, setLineWidth, setStrokingRgbColor,
  setTextMatrix, showText, StandardFonts, stroke, type PDFFont, type PDFName, type PDFOperator, type PDFPage,
} from "pdf-lib";
import type { PageCanvas } from "surfaceflattening";

const pointsPerMillimeter = 72 / 25.4;

/** Pages of a PDF at true scale, by pdf-lib. */
export class PdfCanvas implements PageCanvas {
  private page!: PDFPage;
  private fontName!: PDFName;
  private operators: PDFOperator[] = [];
  private readonly letters: Set<number>;
  /** Words in letters that the font of the PDF lacks. */
  readonly lacking = new Set<string>();

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
    const known = this.inFont(words);
    const back = anchor * this.font.widthOfTextAtSize(known, height);
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    // y is downward, and letters stand upright in it; the baseline lies below the middle of their height.
    const below = 0.35 * height;
    this.operators.push(beginText(), setFontAndSize(this.fontName, height),
      setTextMatrix(cos, -sin, -sin, -cos, x - back * cos + below * sin, y + back * sin + below * cos),
      showText(this.font.encodeText(known)), endText());
  }

  private inFont(words: string): string {
    const known = Array.from(words, (letter) => (this.letters.has(letter.codePointAt(0) ?? 0) ? letter : "?")).join("");
    if (known !== words) {
      this.lacking.add(words);
    }
    return known;
  }
}
