// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/PieceScheme.h"

#include "Angles/ReleaseAdvice.h"

namespace flattening
{
/// Which curves to release for a better piece. Where the piece lies poorly, or wires' angles change
/// by much, the most promising curves are tried: the piece is flattened anew without each, by the
/// same scheme with the same options. With options.tryReleases off none is tried.
ReleaseAdvice adviseByTrials(const PieceContext& context, const FlatWires& flat);
}
