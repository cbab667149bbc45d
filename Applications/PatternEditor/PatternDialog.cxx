// SPDX-License-Identifier: BSD-3-Clause
#include "PatternDialog.h"

#include "Formats/PatternOptionTable.h"

#include <vtkPatternWriter.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QVBoxLayout>

#include <string>

namespace editor
{
using flattening::OptionType;

PatternDialog::PatternDialog(vtkPatternWriter* writer, const PieceEases& eases,
  const std::set<std::string>& curves, QWidget* parent)
  : QDialog(parent)
  , Writer(writer)
  , Form(new QFormLayout)
  , OfCurves(new CurveOptionsTable(writer, eases, curves))
  , Defect(new QLabel)
  , Values(flattening::pattern::patternOptions())
{
  this->setWindowTitle("Pattern options");
  writer->GetOptions(this->Values);
  for (const flattening::Option* const option : this->Values.options())
  {
    // The file has a name already.
    if (option->type != OptionType::List && !option->expert && option->property != "PatternName")
    {
      this->add(*option);
    }
  }

  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  QObject::connect(buttons, &QDialogButtonBox::accepted, this, &PatternDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, this, &PatternDialog::reject);
  auto* const layout = new QVBoxLayout(this);
  layout->addLayout(this->Form);
  this->OfCurves->setObjectName("CurveOptions");
  layout->addWidget(this->OfCurves);
  this->Defect->setObjectName("Defect");
  this->Defect->setWordWrap(true);
  this->Defect->hide();
  layout->addWidget(this->Defect);
  layout->addWidget(buttons);
}

void PatternDialog::accept()
{
  const QString defect = this->OfCurves->defect();
  if (!defect.isEmpty())
  {
    this->Defect->setText(defect);
    this->Defect->show();
    return;
  }
  this->OfCurves->take(this->Writer);
  for (const std::function<void()>& take : this->Take)
  {
    take();
  }
  this->Writer->SetOptions(this->Values);
  this->QDialog::accept();
}

void PatternDialog::add(const flattening::Option& option)
{
  const std::string& property = option.property;
  QWidget* field = nullptr;
  const auto take = [this, &property](const auto& value) {
    this->Take.emplace_back([this, &property, value] { this->Values.set(property, value()); });
  };
  if (option.type == OptionType::Text)
  {
    auto* const text = new QLineEdit(QString::fromStdString(this->Values.text(property)));
    take([text] { return text->text().trimmed().toStdString(); });
    field = text;
  }
  else if (option.type == OptionType::Flag)
  {
    auto* const box = new QCheckBox;
    box->setChecked(this->Values.flag(property));
    take([box] { return box->isChecked() ? 1.0 : 0.0; });
    field = box;
  }
  else if (option.type == OptionType::Word)
  {
    auto* const words = new QComboBox;
    for (const flattening::OptionWord& word : option.words)
    {
      words->addItem(QString::fromStdString(word.name));
    }
    words->setCurrentIndex(this->Values.integer(property));
    take([words] { return static_cast<double>(words->currentIndex()); });
    field = words;
  }
  else
  {
    const bool automatic = !option.automatic.empty();
    auto* const number = new QDoubleSpinBox;
    number->setRange(automatic ? -1.0 : option.minimum, option.maximum);
    number->setSpecialValueText(QString::fromStdString(option.automatic));
    number->setDecimals(option.type == OptionType::Integer ? 0 : 2);
    number->setSuffix(option.form == "MM" ? " mm" : "");
    number->setValue(this->Values.number(property));
    take([number] { return number->value(); });
    field = number;
  }
  field->setObjectName(QString::fromStdString(property));
  field->setToolTip(QString::fromStdString(option.help));
  this->Form->addRow(QString::fromStdString(labelOf(option)), field);
}
}
