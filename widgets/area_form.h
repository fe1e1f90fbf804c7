// The mission area typed in figures, beside drawing it.
#pragma once

#include <optional>

#include <QDoubleSpinBox>
#include <QLabel>
#include <QWidget>

#include "core/base/geometry.h"

namespace usar::widgets {

/// Two corners in metres of the map frame, and what they mean. Values that cross are put in order when told. An area
/// of no size is said in words and not told. GUI thread.
class AreaForm : public QWidget {
    Q_OBJECT
public:
    explicit AreaForm(QWidget* parent = nullptr);

    /// No signal.
    void setArea(const std::optional<Rectangle>& area_in_map);
    /// Values are kept within; an empty rectangle lifts the limit.
    void setLimits(const Rectangle& world_in_map);
    /// Empty where the typed values enclose nothing.
    Rectangle area() const;

signals:
    /// By typing or the arrows, never empty, corners in order.
    void areaChanged(const usar::Rectangle& area_in_map);

private:
    void tell();
    /// Size and surface in words, or what to do when there is none.
    void describe();

    QDoubleSpinBox* min_x_;
    QDoubleSpinBox* max_x_;
    QDoubleSpinBox* min_y_;
    QDoubleSpinBox* max_y_;
    QLabel* size_;
};

} // namespace usar::widgets
