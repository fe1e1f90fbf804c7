#include "widgets/panels/area_form.h"

#include <algorithm>
#include <limits>

#include <QEvent>
#include <QGridLayout>
#include <QSignalBlocker>

#include "widgets/models/figures.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

void showExactly(QDoubleSpinBox* box, double value_m) {
    box->setRange(std::min(box->minimum(), value_m), std::max(box->maximum(), value_m));
    box->setValue(value_m);
}

QDoubleSpinBox* metres(const QString& name, QWidget* parent) {
    auto* box = new QDoubleSpinBox(parent);
    box->setDecimals(1);
    box->setSuffix(QStringLiteral(" m"));
    box->setLocale(QLocale::c());
    box->setAlignment(Qt::AlignRight);
    box->setKeyboardTracking(false);
    box->setRange(-1e5, 1e5);
    box->setMinimumHeight(minimum_target);
    box->setObjectName(name);
    box->setAccessibleName(name);
    box->setMinimumWidth(box->fontMetrics().horizontalAdvance(QStringLiteral("-000.0 m")) + 2 * gap::large);
    return box;
}

} // namespace

AreaForm::AreaForm(QWidget* parent)
    : QWidget(parent)
    , min_x_(metres(tr("Lowest x"), this))
    , max_x_(metres(tr("Highest x"), this))
    , min_y_(metres(tr("Lowest y"), this))
    , max_y_(metres(tr("Highest y"), this)) {
    setAccessibleName(tr("Mission area"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(gap::small);
    grid->setVerticalSpacing(gap::tiny);
    grid->addWidget(new QLabel(QStringLiteral("x"), this), 0, 0);
    grid->addWidget(min_x_, 0, 1);
    grid->addWidget(new QLabel(QStringLiteral("–"), this), 0, 2);
    grid->addWidget(max_x_, 0, 3);
    grid->addWidget(new QLabel(QStringLiteral("y"), this), 1, 0);
    grid->addWidget(min_y_, 1, 1);
    grid->addWidget(new QLabel(QStringLiteral("–"), this), 1, 2);
    grid->addWidget(max_y_, 1, 3);
    grid->addWidget(size_, 2, 0, 1, 4);
    grid->setRowStretch(3, 1);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    size_->setObjectName(QStringLiteral("size"));
    size_->setWordWrap(true);
    size_->setProperty("role", "muted");
    for (QDoubleSpinBox* box : {min_x_, max_x_, min_y_, max_y_})
        connect(box, &QDoubleSpinBox::valueChanged, this, &AreaForm::tell);
    describe();
}

void AreaForm::setArea(const std::optional<Rectangle>& area_in_map) {
    const Rectangle area = area_in_map.value_or(Rectangle{});
    const QSignalBlocker quiet[] = {QSignalBlocker(min_x_), QSignalBlocker(max_x_), QSignalBlocker(min_y_),
                                    QSignalBlocker(max_y_)};
    showExactly(min_x_, area.min_m.x());
    showExactly(max_x_, area.max_m.x());
    showExactly(min_y_, area.min_m.y());
    showExactly(max_y_, area.max_m.y());
    describe();
}

void AreaForm::setLimits(const Rectangle& world) {
    world_in_map_ = world.empty() ? std::nullopt : std::optional(world);
    describe();
}

Rectangle AreaForm::area() const {
    const Vec2 a(min_x_->value(), min_y_->value());
    const Vec2 b(max_x_->value(), max_y_->value());
    return {a.cwiseMin(b), a.cwiseMax(b)};
}

void AreaForm::tell() {
    describe();
    emit areaChanged(area().empty() ? Rectangle{} : area());
}

bool AreaForm::mark(QDoubleSpinBox* box, double minimum_m, double maximum_m) {
    const bool outside = box->value() < minimum_m || box->value() > maximum_m;
    QString tip = tr("%1 of the mission area in the map frame, metres").arg(box->accessibleName());
    if (outside)
        tip += QStringLiteral("\n") +
               tr("This is outside the world, which spans %1 … %2 m").arg(figure(minimum_m, 1), figure(maximum_m, 1));
    box->setToolTip(tip);
    QPalette palette = QWidget::palette();
    if (outside)
        palette.setColor(QPalette::Text, tokens().caution);
    box->setPalette(palette);
    return outside;
}

void AreaForm::describe() {
    const double endless = std::numeric_limits<double>::infinity();
    const Rectangle world = world_in_map_.value_or(Rectangle{Vec2(-endless, -endless), Vec2(endless, endless)});
    QStringList outside;
    for (QDoubleSpinBox* box : {min_x_, max_x_})
        if (mark(box, world.min_m.x(), world.max_m.x()))
            outside << box->accessibleName();
    for (QDoubleSpinBox* box : {min_y_, max_y_})
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
    size_->setText(words);
}

void AreaForm::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange)
        describe();
    QWidget::changeEvent(event);
}

} // namespace usar::widgets
