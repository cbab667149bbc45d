// SPDX-License-Identifier: BSD-3-Clause
#include "KeyPriceOutput.h"

#include "FieldArrays.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPolyData.h"

#include <limits>

namespace flattening
{
namespace bridge
{
namespace
{
struct Row
{
  std::string what;
  Index curve = none;
  double price = std::numeric_limits<double>::quiet_NaN();
  KeyTrial trial;
};

std::string namesOf(const std::vector<FeatureCurve>& curves, const Indices& ids)
{
  std::string names;
  for (const Index id : ids)
  {
    names += (names.empty() ? "" : ", ") + curves[id].name;
  }
  return names;
}
}

void writeKeyPrices(
  const std::vector<FeatureCurve>& curves, const KeyPrices& prices, vtkPolyData* output)
{
  constexpr double no = std::numeric_limits<double>::quiet_NaN();
  std::vector<Row> rows{ { "all keys", none, no, prices.all } };
  for (const KeyPrice& key : prices.keys)
  {
    const std::string& name = curves[key.curve].name;
    rows.push_back({ "without " + name, key.curve, key.price, key.without });
    rows.push_back({ name + " alone", key.curve, no, key.alone });
  }
  rows.push_back({ "no key", none, no, prices.none });

  vtkFieldData* const field = output->GetFieldData();
  const std::size_t count = rows.size();
  addRows<vtkStringArray>(field, "KeyTrial", count, [&](std::size_t r) { return rows[r].what; });
  addRows<vtkIntArray>(field, "KeyCurve", count, [&](std::size_t r) { return rows[r].curve; });
  addRows<vtkDoubleArray>(field, "KeyPrice", count, [&](std::size_t r) { return rows[r].price; });
  addRows<vtkDoubleArray>(
    field, "AreaError", count, [&](std::size_t r) { return rows[r].trial.areaError; });
  addRows<vtkDoubleArray>(
    field, "StrainP95", count, [&](std::size_t r) { return rows[r].trial.strainP95; });
  addRows<vtkStringArray>(
    field, "Status", count, [&](std::size_t r) { return statusName(rows[r].trial.status); });
  addRows<vtkStringArray>(field, "Released", count,
    [&](std::size_t r) { return namesOf(curves, rows[r].trial.released); });
}
}
}
