#include "widgets/panels/behavior_parts.h"

#include <algorithm>
#include <limits>

#include <QFileInfo>
#include <QSignalBlocker>

#include "widgets/models/figures.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"
#include "widgets/style/tips.h"

namespace usar::widgets {
namespace {

void showExactly(QDoubleSpinBox* box, double value_m) {
    const QSignalBlocker quiet(box);
    box->setRange(std::min(box->minimum(), value_m), std::max(box->maximum(), value_m));
    box->setValue(value_m);
}

/// Adds a row with the lowest and the highest value of one axis to the grid.
std::array<QDoubleSpinBox*, 2> addAxis(QGridLayout* grid, int row, const QString& axis, const QStringList& names) {
    std::array<QDoubleSpinBox*, 2> boxes{};
    for (int i = 0; i < 2; ++i) {
        auto* box = boxes[static_cast<std::size_t>(i)] = new QDoubleSpinBox;
        box->setDecimals(1);
        box->setSuffix(QStringLiteral(" m"));
        box->setLocale(QLocale::c());
        box->setAlignment(Qt::AlignRight);
        box->setKeyboardTracking(false);
        box->setRange(-1e5, 1e5);
        box->setMinimumHeight(minimum_target);
        box->setObjectName(names[i]);
        box->setAccessibleName(names[i]);
        box->setMinimumWidth(box->fontMetrics().horizontalAdvance(QStringLiteral("-000.0 m")) + 2 * gap::large);
        grid->addWidget(new QLabel(i == 0 ? axis : QStringLiteral("–")), row, 2 * i);
        grid->addWidget(box, row, 2 * i + 1);
    }
    return boxes;
}

/// Says how much of the area is outside the world, and what that means for its flight.
QString outsideText(const Rectangle& area, const Rectangle& world) {
    const Rectangle inside{area.min_m.cwiseMax(world.min_m), area.max_m.cwiseMin(world.max_m)};
    if (inside.empty())
        return AreaForm::tr("All of the area is there and cannot be flown.");
    return AreaForm::tr("%1 % of the area lies outside and is not flown.")
        .arg(figure(100.0 * (1.0 - inside.area_m2() / area.area_m2()), 1));
}

} // namespace

AreaForm::AreaForm(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Mission area"));
    auto* grid = gridOf(this, {}, gap::small, gap::tiny);
    x_ = addAxis(grid, 0, QStringLiteral("x"), {tr("Lowest x"), tr("Highest x")});
    y_ = addAxis(grid, 1, QStringLiteral("y"), {tr("Lowest y"), tr("Highest y")});
    grid->addWidget(size_, 2, 0, 1, 4);
    grid->setRowStretch(3, 1);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    size_->setObjectName(QStringLiteral("size"));
    size_->setWordWrap(true);
    for (QDoubleSpinBox* box : {x_[0], x_[1], y_[0], y_[1]})
        connect(box, &QDoubleSpinBox::valueChanged, this, [this] {
            describe();
            emit areaChanged(area().empty() ? Rectangle{} : area());
        });
    describe();
}

void AreaForm::setArea(const std::optional<Rectangle>& area_in_map) {
    const Rectangle area = area_in_map.value_or(Rectangle{});
    showExactly(x_[0], area.min_m.x());
    showExactly(x_[1], area.max_m.x());
    showExactly(y_[0], area.min_m.y());
    showExactly(y_[1], area.max_m.y());
    describe();
}

void AreaForm::setLimits(const Rectangle& world) {
    world_in_map_ = world.empty() ? std::nullopt : std::optional(world);
    describe();
}

Rectangle AreaForm::area() const {
    const Vec2 a(x_[0]->value(), y_[0]->value());
    const Vec2 b(x_[1]->value(), y_[1]->value());
    return {a.cwiseMin(b), a.cwiseMax(b)};
}

bool AreaForm::mark(QDoubleSpinBox* box, double minimum_m, double maximum_m) {
    const bool outside = box->value() < minimum_m || box->value() > maximum_m;
    tellRange(box, tr("%1 of the mission area in the map frame, meters").arg(box->accessibleName()));
    if (outside)
        box->setToolTip(
            box->toolTip() + u'\n' +
            tr("This is outside the world, which spans %1 … %2 m").arg(figure(minimum_m, 1), figure(maximum_m, 1)));
    setRole(box, outside ? "caution" : "");
    return outside;
}

void AreaForm::describe() {
    const double endless = std::numeric_limits<double>::infinity();
    const Rectangle world = world_in_map_.value_or(Rectangle{Vec2(-endless, -endless), Vec2(endless, endless)});
    QStringList outside;
    for (QDoubleSpinBox* box : x_)
        if (mark(box, world.min_m.x(), world.max_m.x()))
            outside << box->accessibleName();
    for (QDoubleSpinBox* box : y_)
        if (mark(box, world.min_m.y(), world.max_m.y()))
            outside << box->accessibleName();
    const Rectangle typed = area();
    QString words = typed.empty()
                        ? tr("No area yet. Draw it on the map (A) or type its corners.")
                        : tr("%1 × %2 m = %3 m²")
                              .arg(figure(typed.width_m(), 1), figure(typed.height_m(), 1), figure(typed.area_m2(), 0));
    if (!outside.empty())
        words += u'\n' + tr("%1: outside the world, which spans x\u00a0%2\u00a0…\u00a0%3\u00a0m and "
                            "y\u00a0%4\u00a0…\u00a0%5\u00a0m.")
                             .arg(outside.join(QStringLiteral(", ")), figure(world.min_m.x(), 1),
                                  figure(world.max_m.x(), 1), figure(world.min_m.y(), 1), figure(world.max_m.y(), 1));
    if (!outside.empty() && !typed.empty())
        words += u' ' + outsideText(typed, world);
    size_->setText(words);
}

PlanChoice::PlanChoice(QWidget* parent) : QWidget(parent) {
    laidOut(new QHBoxLayout(this), {}, gap::tiny, {box_})->setStretchFactor(box_, 1);
    box_->setAccessibleName(tr("Plan"));
    box_->setMinimumHeight(minimum_target);
    box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box_->setMinimumContentsLength(12);
    const QToolButton* open = addButton("open", tr("Open plan"), tr("Use a plan of your own (.lap)"));
    const QToolButton* edit = addButton("edit", tr("Edit plan"), tr("View and edit the chosen plan"));
    connect(open, &QToolButton::clicked, this, &PlanChoice::openRequested);
    connect(edit, &QToolButton::clicked, this, &PlanChoice::editRequested);
    connect(box_, &QComboBox::currentIndexChanged, this,
            [this](int index) { box_->setToolTip(box_->itemData(index, Qt::ToolTipRole).toString()); });
    connect(box_, &QComboBox::activated, this, [this] { emit chosen(path()); });
    hide();
}

QToolButton* PlanChoice::addButton(const QString& icon_name, const QString& text, const QString& help) {
    auto* button = named(new QToolButton, text, help);
    button->setIcon(icon(icon_name));
    button->setMinimumSize(minimum_target, minimum_target);
    layout()->addWidget(button);
    return button;
}

void PlanChoice::setBehavior(const std::string& behavior_id, const QString& plan_name) {
    behavior_id_ = plan_name.isEmpty() ? std::string() : behavior_id;
    setVisible(!empty());
    const QSignalBlocker silent(box_);
    box_->clear();
    if (empty())
        return;
    box_->addItem(tr("%1 (comes with the robot)").arg(plan_name), QString());
    box_->setItemData(0, tr("The plan that comes with the robot decides"), Qt::ToolTipRole);
    for (const QString& path : paths_[behavior_id_])
        addFile(path);
    box_->setToolTip(box_->itemData(0, Qt::ToolTipRole).toString());
}

void PlanChoice::choose(const QString& path) {
    if (empty())
        return;
    const QSignalBlocker silent(box_);
    if (box_->findData(path) < 0) {
        paths_[behavior_id_] += path;
        addFile(path);
    }
    box_->setCurrentIndex(box_->findData(path));
    box_->setToolTip(box_->currentData(Qt::ToolTipRole).toString());
}

void PlanChoice::addFile(const QString& path) {
    box_->addItem(QFileInfo(path).fileName(), path);
    box_->setItemData(box_->count() - 1, path, Qt::ToolTipRole);
}

} // namespace usar::widgets
