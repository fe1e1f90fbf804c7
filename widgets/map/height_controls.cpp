#include "widgets/map/height_controls.h"

#include <algorithm>

#include <QGridLayout>
#include <QSignalBlocker>

#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"
#include "widgets/style/tips.h"

namespace usar::widgets {
namespace {

const QString scope_key = QStringLiteral("robots");
const QString all_robots = QStringLiteral("all");
const QString selected_robot = QStringLiteral("selected");
const QString gray_key = QStringLiteral("gray");
const QString fixed_key = QStringLiteral("fixed");
const QString trimmed_key = QStringLiteral("trimmed");
const QString lowest_key = QStringLiteral("lowest_m");
const QString highest_key = QStringLiteral("highest_m");

QuantityBox* heightBox(QWidget* parent, const QString& name, const QString& help) {
    constexpr double far_m = 10000.0;
    auto* const box = new QuantityBox(parent);
    box->setAccessibleName(name);
    box->setRange(-far_m, far_m);
    box->setDecimals(2);
    box->setSuffix(QStringLiteral(" m"));
    tellRange(box, help);
    box->hide();
    return box;
}

} // namespace

HeightControls::HeightControls(QWidget* parent) : QWidget(parent) {
    scope_ = named(new QComboBox(this), tr("Robots whose heights are shown"),
                   tr("One map made of the scans of all robots, or the scan of the selected robot only"));
    scope_->addItems({tr("All robots"), tr("Selected robot")}); // In the order of HeightScope.
    connect(scope_, &QComboBox::currentIndexChanged, this, [this] { emit scopeChanged(scope()); });
    gray_ = named(new QCheckBox(tr("Gray"), this), tr("Gray heights"),
                  tr("Shows heights in shades of gray without light; darker is lower"));
    fixed_ = named(new QCheckBox(tr("Fixed range"), this), tr("Fixed range of heights"),
                   tr("Keeps the heights that the colors stand for; otherwise they follow the scan"));
    trimmed_ = named(new QCheckBox(tr("2–98 %"), this), tr("Range without extreme heights"),
                     tr("The colors leave out the lowest 2 % and the highest 2 % of the cells, so that one tree does "
                        "not take most of them; looked at once a second"));
    lowest_ = heightBox(this, tr("Lowest height"), tr("Height with the darkest color, in meters"));
    highest_ = heightBox(this, tr("Highest height"), tr("Height with the lightest color, in meters"));
    auto* const grid = gridOf(this, {}, gap::small, gap::tiny);
    grid->addWidget(scope_, 0, 0, 1, 2);
    grid->addWidget(gray_, 1, 0);
    grid->addWidget(fixed_, 1, 1);
    grid->addWidget(trimmed_, 2, 0, 1, 2);
    grid->addWidget(lowest_, 3, 0);
    grid->addWidget(highest_, 3, 1);
    connect(fixed_, &QCheckBox::clicked, this, [this] { trimmed_->setChecked(false); });
    connect(trimmed_, &QCheckBox::clicked, this, [this] { fixed_->setChecked(false); });
    for (QCheckBox* const box : {gray_, fixed_, trimmed_}) {
        box->setMinimumHeight(minimum_target);
        connect(box, &QCheckBox::clicked, this, &HeightControls::tell);
    }
    for (QuantityBox* const box : {lowest_, highest_})
        connect(box, &QDoubleSpinBox::valueChanged, this, &HeightControls::tell);
}

mapping::HeightScope HeightControls::scope() const {
    return static_cast<mapping::HeightScope>(scope_->currentIndex());
}

void HeightControls::setScope(mapping::HeightScope scope) {
    scope_->setCurrentIndex(static_cast<int>(scope));
}

HeightLook HeightControls::look() const {
    HeightLook look;
    look.color_map = gray_->isChecked() ? mapping::ColorMap::Gray : mapping::ColorMap::Color;
    if (fixed_->isChecked()) {
        const auto [low_m, high_m] = std::minmax({lowest_->value(), highest_->value()});
        look.fixed_range = {static_cast<float>(low_m), static_cast<float>(high_m)};
    }
    look.trimmed = trimmed_->isChecked();
    return look;
}

void HeightControls::setLook(const HeightLook& look) {
    gray_->setChecked(look.color_map == mapping::ColorMap::Gray);
    if (look.fixed_range)
        setShownRange(*look.fixed_range);
    fixed_->setChecked(look.fixed_range.has_value());
    trimmed_->setChecked(look.trimmed && !look.fixed_range);
    for (QuantityBox* const box : {lowest_, highest_})
        box->setVisible(fixed_->isChecked());
}

void HeightControls::setShownRange(const mapping::HeightRange& range) {
    if (fixed_->isChecked())
        return;
    const QSignalBlocker quiet_lowest(lowest_);
    const QSignalBlocker quiet_highest(highest_);
    lowest_->setValue(double(range.minimum_m));
    highest_->setValue(double(range.maximum_m));
}

QJsonObject HeightControls::saveState() const {
    return {{scope_key, scope_->currentIndex() == 0 ? all_robots : selected_robot},
            {gray_key, gray_->isChecked()},
            {fixed_key, fixed_->isChecked()},
            {trimmed_key, trimmed_->isChecked()},
            {lowest_key, lowest_->value()},
            {highest_key, highest_->value()}};
}

void HeightControls::restoreState(const QJsonObject& state) {
    if (const QString robots = state[scope_key].toString(); robots == all_robots || robots == selected_robot)
        setScope(robots == all_robots ? mapping::HeightScope::AllRobots : mapping::HeightScope::SelectedRobot);
    const HeightLook before = look();
    HeightLook saved;
    if (state[gray_key].toBool(gray_->isChecked()))
        saved.color_map = mapping::ColorMap::Gray;
    if (state[fixed_key].toBool(fixed_->isChecked()))
        saved.fixed_range = {static_cast<float>(state[lowest_key].toDouble(lowest_->value())),
                             static_cast<float>(state[highest_key].toDouble(highest_->value()))};
    saved.trimmed = state[trimmed_key].toBool(trimmed_->isChecked());
    fixed_->setChecked(false); // The figures of an earlier range give way.
    setLook(saved);
    if (look() != before)
        emit lookChanged(look());
}

void HeightControls::tell() {
    setLook(look());
    emit lookChanged(look());
}

} // namespace usar::widgets
