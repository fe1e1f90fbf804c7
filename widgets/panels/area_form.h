// Form for typing the corners of the mission area, as an alternative to drawing it on the map.
#pragma once

#include <array>
#include <optional>

#include <QDoubleSpinBox>
#include <QWidget>

#include "core/base/geometry.h"
#include "widgets/style/form_parts.h"

namespace usar::widgets {

/// Edits two corners in meters of the map frame and describes the resulting rectangle in words. Corners typed in the
/// wrong order are sorted before they are reported. Values outside the world are kept, but shown in another color and
/// named in a sentence; nothing is clamped silently. GUI thread.
class AreaForm : public QWidget {
    Q_OBJECT
public:
    explicit AreaForm(QWidget* parent = nullptr);

    /// Shows this area without emitting a signal; nullopt shows zeros.
    void setArea(const std::optional<Rectangle>& area_in_map);
    /// Sets the extent of the world: values outside it are marked. An empty rectangle removes the limit.
    void setLimits(const Rectangle& world_in_map);
    void clearLimits() { setLimits({}); }
    /// The typed corners in order; empty() if they enclose nothing.
    Rectangle area() const;

signals:
    /// The user typed or stepped a value. Corners are in order; an empty Rectangle{} if they enclose nothing.
    void areaChanged(const usar::Rectangle& area_in_map);

private:
    /// Marks the field if its value is outside the extent of the world; returns true if it is.
    bool mark(QDoubleSpinBox* box, double minimum_m, double maximum_m);
    /// Shows size and surface in words, or what to do while there is no area.
    void describe();

    std::array<QDoubleSpinBox*, 2> x_{}; ///< lowest and highest
    std::array<QDoubleSpinBox*, 2> y_{};
    QLabel* size_ = mutedLabel({}, this);
    std::optional<Rectangle> world_in_map_; ///< nullopt: no limit
};

} // namespace usar::widgets
