// SPDX-License-Identifier: BSD-3-Clause
// clipper-lib as the module calls it: a path is a Float64Array with x, y of each point.
const pathOf = (numbers) => Array.from({ length: numbers.length / 2 }, (_, k) => ({ X: numbers[2 * k], Y: numbers[2 * k + 1] }));
const numbersOf = (path) => Float64Array.from(path.flatMap(({ X, Y }) => [X, Y]));

export function clipperOf(lib) {
  const { Clipper, ClipperOffset, ClipType, EndType, JoinType, PolyFillType, PolyType } = lib;
  return {
    combine(subjects, clips, isUnion, isPositive) {
      const clipper = new Clipper();
      clipper.AddPaths(subjects.map(pathOf), PolyType.ptSubject, true);
      clipper.AddPaths(clips.map(pathOf), PolyType.ptClip, true);
      const fill = isPositive ? PolyFillType.pftPositive : PolyFillType.pftNonZero;
      const result = new lib.Paths();
      clipper.Execute(isUnion ? ClipType.ctUnion : ClipType.ctDifference, result, fill, fill);
      return result.map(numbersOf);
    },
    clean: (paths) => Clipper.CleanPolygons(paths.map(pathOf), 1.415).map(numbersOf),
    sum: (pattern, path, isClosed) => Clipper.MinkowskiSum(pathOf(pattern), pathOf(path), isClosed).map(numbersOf),
    offset(path, miterLimit, arcTolerance, distance) {
      const offset = new ClipperOffset(miterLimit, arcTolerance);
      offset.AddPath(pathOf(path), JoinType.jtMiter, EndType.etClosedPolygon);
      const result = new lib.Paths();
      offset.Execute(result, distance);
      return result.map(numbersOf);
    },
  };
}
