// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options/OptionTable.h"

#include <vtkSmartPointer.h>

#include <string>

class vtkWireWarpingFilter;

namespace CLI
{
class App;
}

namespace wirewarp
{
struct Flattening;

/// Whether and how the surface is moved.
struct ReshapingRequest
{
  bool wanted = false;
  flattening::OptionValues values{ flattening::OptionOwner::Reshaping };

  bool any() const { return this->wanted; }
};

void addReshaping(CLI::App& app, ReshapingRequest& request);

/// The filter that moves the surface before it flattens it.
vtkSmartPointer<vtkWireWarpingFilter> makeReshapingFilter(const ReshapingRequest& request);

/// Gives it the body of this file, where it is one that moves the surface. Throws InputError.
void setBody(const std::string& body, vtkWireWarpingFilter* filter);

/// Takes over what the filter has beside the flattening, where it is one that moves the surface.
void takeReshaped(vtkWireWarpingFilter* filter, Flattening& result);

/// How far the surface was moved for what; empty where it was not.
std::string reshapingTable(const Flattening& result);
}
