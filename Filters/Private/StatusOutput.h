// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"

class vtkFieldData;

namespace flattening
{
namespace bridge
{
/// What became of each piece, with the ids of the input: one row a piece of Status, StatusMessage,
/// StatusDefect and StatusIdKind; one row an id of StatusIdPiece and StatusId; one row a remedy of
/// RemedyPiece, RemedyName and RemedySubject.
void writeStatuses(const std::vector<Status>& statuses, vtkFieldData* field);

/// The defect and its remedies, with the names of the filters' properties and of their inputs'
/// arrays; empty where the status is Ok.
std::string inWords(const Status& status);
}
}
