#include "widgets/area_form.h"

#include <QGridLayout>
#include <QSignalBlocker>

#include "widgets/models/figures.h"
#include "widgets/theme.h"

namespace usar::widgets {

namespace {

QDoubleSpinBox* metres(const QString& name, QWidget* parent) {
    auto* box = new QDoubleSpinBox(parent);
    box->setDecimals(1);
    box->setSuffix(QStringLiteral(" m"));
    box->setLocale(QLocale::c());
    box->setAlignment(Qt::AlignRight);
    box->setKeyboardTracking(false);
    box->setRange(-1e5, 1e5);
    box->setAccessibleName(name);
    box->setToolTip(QObject::tr("%1 of the mission area in the map frame, metres").arg(name));
    box->setMinimumWidth(box->fontMetrics().horizontalAdvance(QStringLiteral("-000.0 m")) + 2 * gap::large);
    return box;
}

} // namespace

AreaForm::AreaForm(QWidget* parent)
    : QWidget(parent)
    , min_x_(metres(tr("Lowest x"), this))
    , max_x_(metres(tr("Highest x"), this))
    , min_y_(metres(tr("Lowest y"), this))
    , max_y_(metres(tr("Highest y"), this))
    , size_(new QLabel(this)) {
    setAccessibleName(tr("Mission area"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(gap::small, gap::tiny, gap::small, gap::tiny);
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
    min_x_->setValue(area.min_m.x());
    max_x_->setValue(area.max_m.x());
    min_y_->setValue(area.min_m.y());
    max_y_->setValue(area.max_m.y());
    describe();
}

void AreaForm::setLimits(const Rectangle& world) {
    const bool none = world.empty();
    const QSignalBlocker quiet[] = {QSignalBlocker(min_x_), QSignalBlocker(max_x_), QSignalBlocker(min_y_),
                                    QSignalBlocker(max_y_)};
    for (QDoubleSpinBox* box : {min_x_, max_x_})
        box->setRange(none ? -1e5 : world.min_m.x(), none ? 1e5 : world.max_m.x());
    for (QDoubleSpinBox* box : {min_y_, max_y_})
        box->setRange(none ? -1e5 : world.min_m.y(), none ? 1e5 : world.max_m.y());
    describe();
}

Rectangle AreaForm::area() const {
    const Vec2 a(min_x_->value(), min_y_->value());
    const Vec2 b(max_x_->value(), max_y_->value());
    return {a.cwiseMin(b), a.cwiseMax(b)};
}

void AreaForm::tell() {
    describe();
    if (!area().empty())
        emit areaChanged(area());
}

void AreaForm::describe() {
    const Rectangle typed = area();
    if (typed.empty())
        size_->setText(tr("No area yet. Draw it on the map (A) or type its corners."));
    else
        size_->setText(tr("%1 × %2 m = %3 m²")
                           .arg(figure(typed.width_m(), 1), figure(typed.height_m(), 1), figure(typed.area_m2(), 0)));
}

} // namespace usar::widgets
