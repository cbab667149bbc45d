// SPDX-License-Identifier: BSD-3-Clause
#include "Report/ReportKeys.h"

#include <map>

namespace flattening
{
namespace
{
/// Those of a proposed line, and others.
std::vector<ReportKey> ofCuts(const std::vector<ReportKey>& others)
{
  using Kind = ReportKind;
  std::vector<ReportKey> keys{
    { "type", "Type", Kind::Text, "" },
    { "name", "Name", Kind::Text, "" },
    { "length", "Length", Kind::Number, "" },
    { "gain", "Gain", Kind::Number, "" },
    { "E_area_before", "AreaErrorBefore", Kind::Number, "" },
    { "E_area_after", "AreaErrorAfter", Kind::Number, "" },
    { "strain_p95_before", "StrainBefore", Kind::Number, "" },
    { "strain_p95_after", "StrainAfter", Kind::Number, "" },
  };
  keys.insert(keys.end(), others.begin(), others.end());
  return keys;
}
}

const std::vector<ReportKey>& reportKeys(const std::string& record)
{
  using Kind = ReportKind;
  static const std::map<std::string, std::vector<ReportKey>> records{
    { "PieceReport",
      {
        { "piece", "Piece", Kind::Integer,
          "its number from 0, the value of the cell array \"PieceId\"." },
        { "name", "Name", Kind::Text,
          "that all of its cells have in the array \"PieceName\", numbered where several pieces "
          "have it." },
        { "status", "Status", Kind::Text,
          "\"Ok\", or the name of the worst warning, such as \"LengthError\"." },
        { "id_kind", "StatusIdKind", Kind::Text,
          "what ids are: \"points\", \"cells\", \"curves\", ..." },
        { "size", "SizeInWords", Kind::Text, "" },
        { "ease", "EaseInWords", Kind::Text,
          "how large the flat piece is, in cm, and where its cloth must be eased in or stretched, "
          "in words." },
        { "triangles", "Triangles", Kind::Integer, "" },
        { "vertices", "Vertices", Kind::Integer, "" },
        { "wire_patches", "WirePatches", Kind::Integer, "" },
        { "wire_nodes", "WireNodes", Kind::Integer, "" },
        { "free_wire_nodes", "FreeWireNodes", Kind::Integer, "" },
        { "constraints", "Constraints", Kind::Integer, "counts." },
        { "iterations", "Iterations", Kind::Integer, "of the wires' angles." },
        { "objective", "Objective", Kind::Number,
          "half the sum of the squared changes of the wires' angles (Eq. 13), rad^2." },
        { "closure_residual", "ClosureResidual", Kind::Number,
          "largest gap of a loop of wires, unit of length." },
        { "E_len", "EdgeLengthError", Kind::Number,
          "mean relative error of the wires' edges (Eq. 26), without connectors, elastic curves "
          "and a free boundary." },
        { "E_len_max", "MaxEdgeLengthError", Kind::Number, "the largest such error." },
        { "E_len_all", "EdgeLengthErrorAll", Kind::Number,
          "mean relative error of all edges of the mesh." },
        { "E_ang", "AngleErrorMean", Kind::Number,
          "mean relative error of the triangles' angles (Eq. 27); 0 is ideal." },
        { "E_h", "GlobalHomogeneity", Kind::Number,
          "homogeneity, min a / max a, a = flat area / area on the surface of a triangle; 1 is "
          "ideal." },
        { "E_r", "GlobalAspectRatio", Kind::Number,
          "aspect ratio, min s / max S, the singular values of the triangles' maps; 1 is ideal." },
        { "E_area", "AreaError", Kind::Number,
          "sum of abs(flat area - area) / sum of area; 0 is ideal." },
        { "strain_p95", "StrainP95", Kind::Number,
          "the strain, max abs(ln sigma), that is not exceeded on 95 % of the area." },
        { "energy_rigid", "RigidEnergy", Kind::Number,
          "mean squared distance of the triangles' maps from a rotation." },
        { "energy_sheet", "DistortionEnergy", Kind::Number, "" },
        { "energy_angles", "AngleEnergy", Kind::Number,
          "the two terms of the energy of scheme \"isometric\", in mean triangle areas." },
        { "cut_length", "CutLength", Kind::Number,
          "length of the darts and seams that bound or slit it." },
        { "flipped", "FlippedTriangles", Kind::Integer, "triangles that are turned over." },
        { "overlaps", "Overlaps", Kind::Integer, "pairs of boundary edges that cross." },
        { "overlaps_complete", "OverlapsComplete", Kind::Truth, "whether all were looked at." },
        { "solver_used", "SolverUsed", Kind::Text, "" },
        { "energy_used", "EnergyUsed", Kind::Text, "of the method; empty where it has none." },
        { "repaired", "Repaired", Kind::Truth,
          "whether progressive angles did not close and the nearest that do were taken." },
        { "fallbacks", "Fallbacks", Kind::Text,
          "what was done instead of what was chosen, and why; else empty. Another energy is among "
          "the warnings." },
        { "verdict", "Verdict", Kind::Text,
          "that no plane can hold the piece, where to cut it, and which other energy was used; "
          "else empty. It is a warning as well." },
        { "forecast_area_loss", "ForecastAreaLoss", Kind::Number, "" },
        { "forecast_area_loss_after_cut", "ForecastAreaLossAfterCut", Kind::Number,
          "part of the area that is lost where the boundary keeps its lengths, as known before "
          "flattening, and with that cut; 0 below 0.3." },
        { "forecast_cut_from", "ForecastCutFrom", Kind::Integer, "" },
        { "forecast_cut_to", "ForecastCutTo", Kind::Integer,
          "points that it joins along edges; -1: none." },
      } },
    { "ClothReport",
      {
        { "strain_warp_rms", "StrainWarpRms", Kind::Number, "" },
        { "strain_weft_rms", "StrainWeftRms", Kind::Number, "" },
        { "shear_rms", "ShearRms", Kind::Number, "root mean squares by area on the surface." },
        { "share_out_of_limit", "ShareOutOfLimit", Kind::Number,
          "share of the area beyond the limits of the material." },
        { "share_over_5_percent", "ShareOver5Percent", Kind::Number,
          "share where warp or weft is drawn or compressed by more than 5 %." },
        { "share_locked", "ShareLocked", Kind::Number,
          "share where the threads are sheared to the material's limit or beyond." },
        { "shear_limit", "ShearLimit", Kind::Limit,
          "that limit, by which the angle between the threads may change; None where there is "
          "none." },
        { "grain_angle", "GrainAngle", Kind::Number,
          "from the curve, or else from the upright of the piece, to the warp, "
          "counter-clockwise." },
        { "grain_curve", "GrainCurve", Kind::Text,
          "name of that curve; empty where it is the upright." },
        { "one_way", "OneWay", Kind::Truth,
          "whether the material must not be turned by half a turn." },
      } },
    { "CurveReport",
      {
        { "name", "Name", Kind::Text, "" },
        { "type", "Type", Kind::Text, "of the curve." },
        { "length_3d", "RestLength", Kind::Number, "" },
        { "length_2d", "FlatLength", Kind::Number, "on the surface and in the plane." },
        { "error", "LengthError", Kind::Number, "largest relative error of one of its edges." },
        { "tolerance", "Tolerance", Kind::Number,
          "how far its length may go, as a fraction; 0 is rigid." },
        { "closed_length", "ClosedLength", Kind::Number,
          "how much of a cut close_cuts has closed." },
        { "sensitivity", "Sensitivity", Kind::Number,
          "derivative of the objective by the logarithm of its length." },
        { "released", "Released", Kind::Truth,
          "whether a key's shape was given up, by release_keys or since it clashes with others." },
      } },
    { "AngleStep",
      {
        { "phase", "Phase", Kind::Text, "which problem it belongs to." },
        { "objective", "Objective", Kind::Number, "of Eq. 13, rad^2." },
        { "closure", "Closure", Kind::Number,
          "largest gap of a loop of wires, as a fraction of the perimeter." },
        { "optimality", "Optimality", Kind::Number,
          "largest entry of the gradient of the Lagrangian." },
        { "step", "Step", Kind::Number, "root mean square of the change of the angles, radians." },
      } },
    { "IsometricStep",
      {
        { "exact", "Exact", Kind::Truth,
          "whether the Hessian was exact, otherwise its convex part." },
        { "energy", "Energy", Kind::Number, "what is minimized." },
        { "length_error", "LengthError", Kind::Number, "largest error of a wire's edge." },
        { "optimality", "Optimality", Kind::Number,
          "largest entry of the gradient of the Lagrangian." },
        { "move", "Move", Kind::Number, "of the vertex that moved farthest." },
      } },
    { "LeftOut",
      {
        { "reason", "Reason", Kind::Text, "\"ClosedSurface\" or \"Handle\"." },
        { "cell", "Cell", Kind::Integer, "the first of its triangles." },
        { "triangles", "Triangles", Kind::Integer, "how many it has." },
      } },
    { "LeftOutLine",
      {
        { "name", "Name", Kind::Text, "" },
        { "type", "Type", Kind::Text, "\"key\" or \"accessory\"." },
        { "length", "Length", Kind::Number, "on the surface, unit of length." },
        { "gain", "Gain", Kind::Number, "what it costs, as SuggestedCut.gain." },
        { "E_area_before", "AreaErrorBefore", Kind::Number, "" },
        { "E_area_after", "AreaErrorAfter", Kind::Number, "mean change of area." },
        { "strain_before", "StrainBefore", Kind::Number, "" },
        { "strain_after", "StrainAfter", Kind::Number, "the largest strain on 95 % of a piece." },
        { "sound", "Sound", Kind::Truth,
          "whether the result with it is sound; it then only costs too much." },
      } },
    { "SuggestedCut",
      {
        { "length", "Length", Kind::Number, "on the surface, unit of length." },
        { "predicted_gain", "PredictedGain", Kind::Number,
          "by how much it lowers the mean of the squared scale factor, by forecast." },
        { "gain", "Gain", Kind::Number,
          "by how much it lowers the mean rigid energy, as measured, after the cuts before it; of "
          "a line what it costs, negative. NaN, as strain and E_area, where the surface cannot be "
          "flattened without it, such as a closed one." },
        { "opening", "Opening", Kind::Number,
          "of a dart's mouth, or of the widest place of one inside, by forecast, unit of "
          "length." },
        { "strain_before", "StrainBefore", Kind::Number, "" },
        { "strain_after", "StrainAfter", Kind::Number, "the largest strain on 95 % of a piece." },
        { "mirror_of", "MirrorOf", Kind::Integer,
          "place of the cut that it is the mirror image of, or -1." },
        { "E_area_before", "AreaErrorBefore", Kind::Number, "" },
        { "E_area_after", "AreaErrorAfter", Kind::Number, "mean change of area." },
      } },
    { "Flattenable",
      {
        { "bound_met", "BoundMet", Kind::Truth,
          "whether the strain of every piece is within the bound." },
        { "strain_before", "StrainBefore", Kind::Number, "" },
        { "strain_after", "StrainAfter", Kind::Number, "the largest strain on 95 % of a piece." },
        { "size", "Size", Kind::Number, "root of the area of the design, unit of length." },
        { "shift_mean", "ShiftMean", Kind::Number, "" },
        { "shift_max", "ShiftMax", Kind::Number,
          "how far the points were moved, by area; unit of length." },
        { "shift_outwards_mean", "ShiftOutwardsMean", Kind::Number,
          "the mean, by area, of the part of the shift along the normals of the design; below 0 "
          "inwards." },
        { "shift_inwards_max", "ShiftInwardsMax", Kind::Number,
          "how far a point was moved inwards, at most; 0: none was." },
      } },
    { "ResewnShape",
      {
        { "pieces", "Pieces", Kind::Integer, "" },
        { "triangles", "Triangles", Kind::Integer, "how many it has." },
        { "size", "Size", Kind::Number, "root of the area of the design, unit of length." },
        { "distance_mean", "DistanceMean", Kind::Number, "" },
        { "distance_rms", "DistanceRms", Kind::Number, "" },
        { "distance_p95", "DistanceP95", Kind::Number, "" },
        { "distance_max", "DistanceMax", Kind::Number,
          "from the cloth at rest to the design, by area; max is the Hausdorff distance. Unit of "
          "length." },
        { "distance_mean_relative", "RelativeDistanceMean", Kind::Number, "" },
        { "distance_max_relative", "RelativeDistanceMax", Kind::Number, "the same over size." },
        { "normal_deviation_mean", "NormalDeviationMean", Kind::Number,
          "mean angle between the normals of cloth and design, radians." },
        { "strain_mean", "StrainMean", Kind::Number, "" },
        { "strain_p95", "StrainP95", Kind::Number, "" },
        { "strain_max", "StrainMax", Kind::Number, "max |ln sigma| of a triangle, by area." },
        { "compressed_area", "CompressedArea", Kind::Number,
          "share of the area that is compressed by more than 0.1 %, where cloth wrinkles." },
        { "energy_membrane", "MembraneEnergy", Kind::Number, "" },
        { "energy_bending", "BendingEnergy", Kind::Number,
          "over half of Young's modulus, unit of length squared." },
        { "body_depth", "BodyDepth", Kind::Number,
          "how deep a point that is not held lies in the body; 0: none does. Unit of length." },
        { "second_distance_mean", "SecondDistanceMean", Kind::Number, "" },
        { "several_shapes", "SeveralShapes", Kind::Truth,
          "mean distance of the shape that a second start finds, and whether it is another one." },
        { "iterations", "Iterations", Kind::Integer, "how many it took." },
        { "converged", "Converged", Kind::Truth, "whether the cloth is at rest." },
      } },
    { "ResewnThreads",
      {
        { "strain_warp_rms", "StrainWarpRms", Kind::Number, "" },
        { "strain_weft_rms", "StrainWeftRms", Kind::Number, "" },
        { "shear_rms", "ShearRms", Kind::Number, "" },
      } },
    { "suggestions",
      ofCuts({
        { "gain_predicted", "PredictedGain", Kind::Number, "" },
        { "opening", "Opening", Kind::Number, "" },
        { "mirror_of", "MirrorOf", Kind::Text, "" },
      }) },
    { "suggestions_left_out", ofCuts({ { "sound", "Sound", Kind::Truth, "" } }) },
    { "key_prices",
      {
        { "trial", "Trial", Kind::Text, "" },
        { "price", "Price", Kind::Number, "" },
        { "E_area", "AreaError", Kind::Number, "" },
        { "strain_p95", "StrainP95", Kind::Number, "" },
        { "status", "Status", Kind::Text, "" },
        { "released", "Released", Kind::Text, "" },
      } },
  };
  static const std::vector<ReportKey> unknown;
  const auto found = records.find(record);
  return found == records.end() ? unknown : found->second;
}
}
