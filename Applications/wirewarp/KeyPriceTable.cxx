// SPDX-License-Identifier: BSD-3-Clause
#include "KeyPriceTable.h"

#include "PlainText.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace wirewarp
{
//------------------------------------------------------------------------------
std::vector<KeyTrialRow> keyTrials(const Flattening& result)
{
  std::vector<KeyTrialRow> rows;
  vtkTable* const table = result.keyPrices;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    rows.push_back({ textIn(table, row, "Trial"), numberIn(table, row, "Price"),
      numberIn(table, row, "AreaError"), numberIn(table, row, "StrainP95"),
      textIn(table, row, "Status"), textIn(table, row, "Released") });
  }
  return rows;
}

//------------------------------------------------------------------------------
std::string keyPriceTable(const Flattening& result)
{
  const std::vector<KeyTrialRow> rows = keyTrials(result);
  if (rows.empty())
  {
    return "";
  }
  std::size_t width = 0;
  for (const KeyTrialRow& row : rows)
  {
    width = std::max(width, plainText(row.what).size());
  }
  std::ostringstream text;
  text << '\n'
       << std::left << std::setw(static_cast<int>(width)) << "trial" << std::right << std::setw(12)
       << "price" << std::setw(12) << "E_area" << std::setw(12) << "strain_p95"
       << "  status\n";
  text << std::fixed << std::setprecision(5);
  const auto number = [&text](double value) {
    text << std::setw(12);
    std::isnan(value) ? text << "" : text << value;
  };
  for (const KeyTrialRow& row : rows)
  {
    text << std::left << std::setw(static_cast<int>(width)) << plainText(row.what) << std::right;
    number(row.price);
    number(row.areaError);
    number(row.strainP95);
    text << "  " << row.status
         << (row.released.empty() ? "" : ", gave up " + plainText(row.released)) << '\n';
  }
  return text.str();
}
}
