// Parts of the behavior panel: a form for typing the corners of the mission area, as an alternative to drawing it on
// the map; and the choice of the plan that a behavior runs, the one that comes with the robot or a file of the user's.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QStringList>
#include <QWidget>

#include "core/base/geometry.h"
#include "widgets/style/form_parts.h"

class QToolButton;

namespace usar::widgets {

/// Edits two corners in meters of the map frame and describes the resulting rectangle in words. Corners typed in the
/// wrong order are sorted before they are reported. Values outside the world are kept, but shown in another color and
/// named in a sentence, with the share of the area that cannot be flown; nothing is clamped silently. GUI thread.
class AreaForm : public QWidget {
    Q_OBJECT
public:
    explicit AreaForm(QWidget* parent = nullptr);

    /// Shows this area without emitting a signal; nullopt shows zeros.
    void setArea(const std::optional<Rectangle>& area_in_map);
    /// Sets the extent of the world: values outside it are marked. An empty rectangle removes the limit.
    void setLimits(const Rectangle& world_in_map);
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

/// A list of plans with two buttons. Remembers the chosen files of each behavior. GUI thread.
class PlanChoice : public QWidget {
    Q_OBJECT
public:
    explicit PlanChoice(QWidget* parent = nullptr);

    /// Shows the choices of this behavior and selects the built-in plan, called `plan_name`. An empty `plan_name` means
    /// that the behavior has no plan: the widget is hidden. Emits nothing.
    void setBehavior(const std::string& behavior_id, const QString& plan_name);
    /// Selects this file, added to the list if it is new; an empty path selects the built-in plan. Emits nothing.
    void choose(const QString& path);
    /// The chosen file; empty for the built-in plan.
    QString path() const { return box_->currentData().toString(); }
    /// True for a behavior without a plan.
    bool empty() const { return behavior_id_.empty(); }

signals:
    /// By the user; empty for the built-in plan.
    void chosen(const QString& path);
    /// The user wants a file that is not in the list.
    void openRequested();
    /// The user wants to edit the chosen plan.
    void editRequested();

private:
    void addFile(const QString& path);
    QToolButton* addButton(const QString& icon_name, const QString& text, const QString& help);

    QComboBox* box_ = new QComboBox;
    std::string behavior_id_; ///< empty: the behavior has no plan
    /// Chosen files by behavior.
    std::map<std::string, QStringList> paths_;
};

} // namespace usar::widgets
