// The mission area typed in figures, beside drawing it.
#pragma once

#include <optional>

#include <QDoubleSpinBox>
#include <QLabel>
#include <QWidget>

#include "core/base/geometry.h"

namespace usar::widgets {

/// Two corners in metres of the map frame, and what they mean. Values that cross are put in order when told. What lies
/// outside the world is shown as it is, in another color and in words; nothing is pulled in silently. GUI thread.
class AreaForm : public QWidget {
    Q_OBJECT
public:
    explicit AreaForm(QWidget* parent = nullptr);

    /// No signal.
    void setArea(const std::optional<Rectangle>& area_in_map);
    /// Values outside are marked; an empty rectangle lifts the limit.
    void setLimits(const Rectangle& world_in_map);
    void clearLimits() { setLimits({}); }
    /// Empty where the typed values enclose nothing.
    Rectangle area() const;

signals:
    /// By typing or the arrows, corners in order; the empty Rectangle{} where they enclose nothing.
    void areaChanged(const usar::Rectangle& area_in_map);

protected:
    void changeEvent(QEvent* event) override;

private:
    void tell();
    /// Marks the field where it is outside the span of the world.
    bool mark(QDoubleSpinBox* box, double minimum_m, double maximum_m);
    /// Size and surface in words, or what to do when there is none.
    void describe();

    QDoubleSpinBox* min_x_;
    QDoubleSpinBox* max_x_;
    QDoubleSpinBox* min_y_;
    QDoubleSpinBox* max_y_;
    QLabel* size_;
    std::optional<Rectangle> world_in_map_;
};

} // namespace usar::widgets
