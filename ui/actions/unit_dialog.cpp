// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/unit_dialog.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <algorithm>
#include <array>

#include "engine/scene/scene.hpp"
#include "ui/format.hpp"

namespace sonde::ui {
namespace {

struct Unit {
  const char* key;
  const char* name;
};
constexpr std::array<Unit, 6> units{{{"m", "metres"},
                                     {"cm", "centimetres"},
                                     {"mm", "millimetres"},
                                     {"um", "micrometres"},
                                     {"in", "inches"},
                                     {"ft", "feet"}}};

QString size_text(const Vec3& metres, const LengthUnit& unit) {
  QString sides;
  for (const double side : metres)
    sides += (sides.isEmpty() ? QString() : QStringLiteral(" × ")) + number(side / unit.metres());
  return sides + ' ' + unit.name();
}

QString name_of_file(const std::filesystem::path& file) {
  return QString::fromStdString(file.filename().string()).toHtmlEscaped();
}

}  // namespace

UnitDialog::UnitDialog(const MeshPair& pair, QWidget* parent)
    : QDialog(parent),
      probe_size_(pair.probe_size),
      fixed_size_(pair.fixed_size),
      unit_(new QComboBox(this)),
      sizes_(new QLabel(this)) {
  setObjectName(QStringLiteral("unit_dialog"));
  setWindowTitle(QStringLiteral("Unit of the meshes"));
  auto* layout = new QFormLayout(this);
  layout->addRow(new QLabel(QStringLiteral("Probe <b>%1</b>, fixed body <b>%2</b>.<br>"
                                           "Mesh files do not say their unit. Which is it?")
                                .arg(name_of_file(pair.probe_file), name_of_file(pair.fixed_file)),
                            this));
  unit_->setObjectName(QStringLiteral("unit_choice"));
  const QString guess = QLatin1String(guess_unit(pair));
  for (const Unit& unit : units) {
    const QString key = QLatin1String(unit.key);
    unit_->addItem(
        QLatin1String(unit.name) + (key == guess ? QStringLiteral(" (a guess)") : QString()), key);
  }
  unit_->setCurrentIndex(unit_->findData(guess));
  layout->addRow(QStringLiteral("Unit"), unit_);
  layout->addRow(QStringLiteral("Sizes"), sizes_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  layout->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(unit_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] { show_sizes(); });
  show_sizes();
}

double UnitDialog::metres() const {
  return unit_in_metres(unit_->currentData().toString().toStdString()).value_or(1);
}

void UnitDialog::show_sizes() {
  // One unit for both: they are there to be compared.
  const LengthUnit unit(std::max(probe_size_.maxCoeff(), fixed_size_.maxCoeff()) * metres() / 2);
  sizes_->setText(
      QStringLiteral("probe %1<br>fixed body %2")
          .arg(size_text(probe_size_ * metres(), unit), size_text(fixed_size_ * metres(), unit)));
}

}  // namespace sonde::ui
