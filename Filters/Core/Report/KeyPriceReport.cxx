// SPDX-License-Identifier: BSD-3-Clause
#include "Report/KeyPriceReport.h"

#include <limits>
#include <string>

namespace flattening
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

Columns keyPriceTable(const std::vector<FeatureCurve>& curves, const KeyPrices& prices)
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

  Columns table;
  const TableColumns<Row> columns(table, rows);
  columns.add("Trial", &Row::what);
  columns.add("Status", [](const Row& row) { return statusName(row.trial.status); });
  columns.add("Curve", &Row::curve);
  columns.add("Price", &Row::price);
  columns.add("AreaError", [](const Row& row) { return row.trial.areaError; });
  columns.add("StrainP95", [](const Row& row) { return row.trial.strainP95; });
  columns.add(
    "Released", [&curves](const Row& row) { return namesOf(curves, row.trial.released); });
  return table;
}
}
