// SPDX-License-Identifier: BSD-3-Clause
#include "FormerOptions.h"

#include <map>

namespace wirewarp
{
//------------------------------------------------------------------------------
std::string successorOf(const std::string& option)
{
  static const std::map<std::string, std::string> successors{
    { "--suggest", "wirewarp cut SURFACE --kind darts|seams|all|lines -o curves.vtp" },
    { "--bound", "wirewarp cut SURFACE --max-strain STRAIN" },
    { "--max-cut-length", "wirewarp cut SURFACE --max-length LENGTH" },
    { "--symmetric", "wirewarp cut SURFACE --no-symmetric" },
    { "--no-split", "--no-split-triangles" },
    { "--price-keys", "wirewarp prices SURFACE CURVES" },
    { "--flattenable", "wirewarp reshape SURFACE --max-strain STRAIN" },
    { "--outside-bias", "wirewarp reshape SURFACE --outward SHARE" },
    { "--resew", "wirewarp sew DIR --mode panel|product" },
    { "--resew-thickness", "wirewarp sew DIR --thickness T" },
    { "--resew-iterations", "wirewarp sew DIR --sewing-iterations N" },
    { "--resew-pressure", "wirewarp sew DIR --pressure P" },
    { "--resew-gravity", "wirewarp sew DIR --gravity X Y Z" },
    { "--resew-once", "wirewarp sew DIR --once" },
    { "--svg", "wirewarp pattern DIR -o pattern.svg" },
    { "--pdf", "wirewarp pattern DIR -o pattern.pdf" },
    { "--dxf", "wirewarp pattern DIR -o pattern.dxf" },
    { "--plt", "wirewarp pattern DIR -o pattern.plt" },
    { "--garmentcode", "wirewarp pattern DIR -o pattern.json" },
    { "--walk", "wirewarp pattern DIR -o seams.csv, or --seam-table in the PDF" },
    { "--piece-name", "wirewarp pattern DIR --piece NAME" },
    { "--piece-quantity", "wirewarp pattern DIR --piece NAME:COPIES" },
    { "--curve-allowance", "wirewarp pattern DIR --allowance NAME=MM" },
    { "--curve-notch", "wirewarp pattern DIR --notch NAME=MM" },
    { "--double-notches", "wirewarp pattern DIR --double-notch NAME" },
    { "--cut-on-fold", "wirewarp pattern DIR --fold symmetric" },
    { "--curve-dart-tip", "wirewarp pattern DIR --dart-tip NAME=MM" },
    { "--cut-pairs", "wirewarp pattern DIR --pairs" },
    { "--fair", "wirewarp pattern DIR --smooth MM" },
    { "--curve-fair", "wirewarp pattern DIR --smooth NAME=MM" },
    { "--laser-colors", "wirewarp pattern DIR --style laser" },
    { "--fabric-width", "wirewarp nest DIR --roll-width MM" },
    { "--fabric-gap", "wirewarp nest DIR --gap MM" },
    { "--grade", "wirewarp grade SIZE=SURFACE SIZE=SURFACE CURVES" },
    { "--grade-at", "wirewarp grade SIZE=SURFACE SIZE=SURFACE CURVES --at NAME" },
    { "--picture", "wirewarp picture DIR -o FILE.png" },
    { "--color-by", "wirewarp picture DIR --color MEASURE" },
    { "--batch", "wirewarp batch LIST" },
    { "--list-curves", "--table" },
    { "--list-materials", "wirewarp materials" },
  };
  const auto found = successors.find(option);
  return found == successors.end() ? std::string() : found->second;
}
}
