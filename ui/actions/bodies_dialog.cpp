// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/bodies_dialog.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "engine/mesh_io/read_mesh.hpp"
#include "engine/text/file_unit.hpp"
#include "engine/text/number_text.hpp"
#include "ui/base/format.hpp"

namespace sonde::ui {
namespace {

constexpr double far_apart = 30;  // times larger: one of the units is probably another

constexpr double mm = 1e-3;  // the unit of an offset

/// A factor from a millionth to a million, shown with as many digits as it has.
class ScaleBox : public QDoubleSpinBox {
 public:
  explicit ScaleBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setDecimals(12);
    setRange(1e-9, 1e9);
    setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  }
  QString textFromValue(double value) const override {
    return QString::fromStdString(number_text(value, 6));
  }
  double valueFromText(const QString& text) const override {
    return parse_number(text.trimmed().toStdString()).value_or(1);
  }
  QValidator::State validate(QString& text, int& /*position*/) const override {
    const auto value = parse_number(text.trimmed().toStdString());
    if (value && *value >= minimum() && *value <= maximum()) return QValidator::Acceptable;
    return QValidator::Intermediate;
  }
};

/// A length in millimetres, zero or more.
class LengthBox : public ScaleBox {
 public:
  explicit LengthBox(QWidget* parent) : ScaleBox(parent) {
    setRange(0, 1e9);
    setSuffix(QStringLiteral(" mm"));
  }
  double valueFromText(const QString& text) const override {
    return ScaleBox::valueFromText(bare(text));
  }
  QValidator::State validate(QString& text, int& position) const override {
    QString number = bare(text);
    return ScaleBox::validate(number, position);
  }

 private:
  QString bare(QString text) const { return text.remove(suffix().trimmed()); }
};

QString size_text(const Vec3& metres, const LengthUnit& unit) {
  QString sides;
  for (const double side : metres)
    sides += (sides.isEmpty() ? QString() : QStringLiteral(" × ")) + number(side / unit.metres());
  return sides + ' ' + unit.name();
}

QString counted(std::size_t n, const char* one, const char* more) {
  return QStringLiteral("%1 %2").arg(n).arg(QLatin1String(n == 1 ? one : more));
}

/// What keeps the inside from counting; also what does not, and may surprise.
QString found_text(const Topology& edges) {
  QStringList found;
  if (edges.open_edges > 0)
    found << counted(edges.open_edges, "open edge: there is a hole", "open edges: there are holes");
  if (edges.misoriented_edges > 0)
    found << counted(edges.misoriented_edges, "edge between flipped faces",
                     "edges between flipped faces");
  if (edges.nonmanifold_edges > 0)
    found << counted(edges.nonmanifold_edges, "edge of three faces or more",
                     "edges of three faces or more");
  if (edges.duplicate_triangles > 0)
    found << counted(edges.duplicate_triangles, "repeated triangle", "repeated triangles");
  const QString verdict = edges.closed
                              ? QStringLiteral("closed: the inside counts")
                              : QStringLiteral("not closed as it is: counts if it looks closed");
  return verdict + (found.isEmpty() ? QString() : QStringLiteral("\n") + found.join('\n'));
}

QString name_of_file(const std::filesystem::path& file) {
  return QString::fromStdString(file.filename().string());
}

/// The file states its unit: there is nothing to choose.
void keep_unit(QComboBox& unit) {
  unit.setEnabled(false);
  unit.setItemText(unit.currentIndex(), QStringLiteral("stated in the file"));
}

QLabel* plain(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setTextFormat(Qt::PlainText);  // file names
  return label;
}

}  // namespace

BodiesDialog::BodiesDialog(const MeshPair& pair, const PairSetup& guess, QWidget* parent)
    : QDialog(parent), pair_(pair), warning_(new QLabel(this)) {
  setObjectName(QStringLiteral("bodies_dialog"));
  setWindowTitle(QStringLiteral("What the mesh files do not say"));
  auto* grid = new QGridLayout(this);
  grid->setHorizontalSpacing(18);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(2, 1);
  const char* const rows[] = {"",     "Unit",  "Scale", "Up is", "Inside",
                              "Mesh", "Found", "Size",  "Taken"};
  for (int row = 0; row < 9; ++row)
    grid->addWidget(new QLabel(QLatin1String(rows[row]), this), row, 0, Qt::AlignTop);
  grid->addWidget(plain(QStringLiteral("Probe: ") + name_of_file(pair.probe_file), this), 0, 1);
  grid->addWidget(plain(QStringLiteral("Fixed body: ") + name_of_file(pair.fixed_file), this), 0,
                  2);
  probe_ = add_column(*grid, 1, "probe", guess.probe, pair.probe_edges);
  fixed_ = add_column(*grid, 2, "fixed", guess.fixed, pair.fixed_edges);
  if (has_own_unit(pair.probe_file)) keep_unit(*probe_.unit);
  if (has_own_unit(pair.fixed_file)) keep_unit(*fixed_.unit);
  warning_->setObjectName(QStringLiteral("size_warning"));
  warning_->setWordWrap(true);
  grid->addWidget(add_offset(probe_, guess.probe.offset), 8, 1);
  grid->addWidget(warning_, 9, 0, 1, 3);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  same_size_ = buttons->addButton(QStringLiteral("Same size"), QDialogButtonBox::ActionRole);
  same_size_->setObjectName(QStringLiteral("same_size"));
  same_size_->setToolTip(
      QStringLiteral("Scales the probe so that it is as large as the fixed body"));
  grid->addWidget(buttons, 10, 0, 1, 3);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(same_size_, &QPushButton::clicked, this,
          [this] { probe_.scale->setValue(same_size_scale(pair_, setup())); });
  show_sizes();
}

BodiesDialog::Column BodiesDialog::add_column(QGridLayout& grid, int at, const char* object,
                                              const BodySetup& guess, const Topology& edges) {
  const auto named = [object](auto* widget, const char* what) {
    widget->setObjectName(QLatin1String(object) + QLatin1String(what));
    return widget;
  };
  Column column{};
  column.unit = named(new QComboBox(this), "_unit");
  const auto text = [](std::string_view of) {
    return QString::fromUtf8(of.data(), static_cast<int>(of.size()));
  };
  for (const FileUnit& unit : file_units())
    column.unit->addItem(text(unit.plural), text(unit.name));
  column.unit->setCurrentIndex(
      column.unit->findData(QString::fromStdString(unit_name(guess.unit).value_or("m"))));
  column.scale = named(new ScaleBox(this), "_scale");
  column.scale->setValue(guess.scale);
  column.up = named(new QComboBox(this), "_up");
  column.up->addItems({QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")});
  column.up->setCurrentIndex(static_cast<int>(guess.up));
  column.model = named(new QComboBox(this), "_model");
  column.model->addItem(QStringLiteral("counts where it looks closed"));
  column.model->addItem(QStringLiteral("counts (solid)"));
  column.model->addItem(QStringLiteral("does not count (surface)"));
  column.model->setCurrentIndex(static_cast<int>(guess.model));
  column.as_in_file = named(new QCheckBox(QStringLiteral("as in the file"), this), "_as_in_file");
  column.as_in_file->setChecked(guess.repair == Repair::none);
  column.as_in_file->setToolTip(
      QStringLiteral("Cracks, turned parts and small openings of the mesh are not mended."));
  column.found = named(plain(found_text(edges), this), "_found");
  column.size = named(new QLabel(this), "_size");
  QWidget* const widgets[] = {column.unit,       column.scale, column.up,  column.model,
                              column.as_in_file, column.found, column.size};
  int row = 1;
  for (QWidget* widget : widgets) grid.addWidget(widget, row++, at, Qt::AlignTop);
  const auto changed = [this] { show_sizes(); };
  connect(column.unit, qOverload<int>(&QComboBox::currentIndexChanged), this, changed);
  connect(column.scale, qOverload<double>(&QDoubleSpinBox::valueChanged), this, changed);
  return column;
}

QWidget* BodiesDialog::add_offset(Column& column, double metres) {
  auto* both = new QWidget(this);
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  column.offset_way = new QComboBox(both);
  column.offset_way->setObjectName(QStringLiteral("probe_offset_way"));
  column.offset_way->addItems({QStringLiteral("as it is"), QStringLiteral("smaller (allowance) by"),
                               QStringLiteral("larger (safety) by")});
  column.offset_way->setToolTip(
      QStringLiteral("Moves each face of the probe by that length, so that a peg as large as its "
                     "hole fits; its mass stays that of the mesh"));
  column.offset = new LengthBox(both);
  column.offset->setObjectName(QStringLiteral("probe_offset"));
  column.offset->setValue(std::abs(metres) / mm);
  row->addWidget(column.offset_way);
  row->addWidget(column.offset, 1);
  QDoubleSpinBox* const box = column.offset;
  const auto changed = [box](int way) { box->setEnabled(way != 0); };
  connect(column.offset_way, qOverload<int>(&QComboBox::currentIndexChanged), this, changed);
  if (metres != 0) column.offset_way->setCurrentIndex(metres < 0 ? 1 : 2);
  changed(column.offset_way->currentIndex());
  return both;
}

BodySetup BodiesDialog::setup_of(const Column& column) const {
  const int way = column.offset_way ? column.offset_way->currentIndex() : 0;
  const double offset = way == 0 ? 0 : (way == 1 ? -mm : mm) * column.offset->value();
  return {unit_in_metres(column.unit->currentData().toString().toStdString()).value_or(1),
          column.scale->value(),
          static_cast<UpAxis>(column.up->currentIndex()),
          static_cast<Model>(column.model->currentIndex()),
          column.as_in_file->isChecked() ? Repair::none : Repair::automatic,
          offset};
}

PairSetup BodiesDialog::setup() const { return {setup_of(probe_), setup_of(fixed_)}; }

void BodiesDialog::show_sizes() {
  if (!probe_.size || !fixed_.size) return;  // half built
  const PairSetup now = setup();
  const Vec3 probe = pair_.probe_size * now.probe.unit * now.probe.scale;
  const Vec3 fixed = pair_.fixed_size * now.fixed.unit * now.fixed.scale;
  // One unit for both: they are there to be compared.
  const LengthUnit unit(std::max(probe.maxCoeff(), fixed.maxCoeff()) / 2);
  probe_.size->setText(size_text(probe, unit));
  fixed_.size->setText(size_text(fixed, unit));
  const double least = std::min(probe.maxCoeff(), fixed.maxCoeff());
  const double ratio = least > 0 ? std::max(probe.maxCoeff(), fixed.maxCoeff()) / least : 1;
  const bool apart = ratio > far_apart;
  same_size_->setVisible(apart);
  warning_->setText(apart
                        ? QStringLiteral("One is %1 times larger than the other: is a unit wrong?")
                              .arg(number(ratio))
                        : QStringLiteral("Are these bodies really as large as that?"));
}

}  // namespace sonde::ui
