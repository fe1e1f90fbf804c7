// What the selected robot should do: behavior, mission area, parameters, and the buttons that make it so.
#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "core/agent/robot_plugin.h"
#include "core/base/geometry.h"
#include "widgets/area_form.h"

class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace usar::widgets {

/// What the buttons may do now.
enum class RunState { NoRobot, Ready, Running, Paused };

/// Forwards intent as signals and shows what it is told; decides nothing. Lives in the GUI thread.
class BehaviorPanel : public QWidget {
    Q_OBJECT
public:
    /// `parameter_form` is shown below the area; the panel becomes its parent.
    explicit BehaviorPanel(QWidget* parameter_form, QWidget* parent = nullptr);

    void setBehaviors(const std::vector<agent::BehaviorDescription>& behaviors);
    void chooseBehavior(const std::string& id);
    /// Empty when there is none.
    std::string behaviorId() const;

    /// Nothing: not drawn yet.
    void setArea(const std::optional<Rectangle>& area_in_map) { area_form_->setArea(area_in_map); }
    void setAreaLimits(const Rectangle& world_in_map) { area_form_->setLimits(world_in_map); }
    Rectangle area() const { return area_form_->area(); }
    /// "5 lanes · 312 m · 6 min 10 s", or why there are none.
    void setPlanSummary(const QString& summary);
    /// True when this changed what the buttons may do.
    bool setRunState(RunState state, const QString& robot_name);
    void setAreaToolActive(bool active);

signals:
    void behaviorChosen(const QString& id);
    void areaTyped(const usar::Rectangle& area_in_map);
    void areaToolToggled(bool active);
    void startRequested();
    void pauseRequested(bool paused);
    void landRequested();
    void stopRequested();

private:
    QWidget* makeAreaBox();
    QWidget* makeButtons();

    QLabel* robot_label_;
    QComboBox* behavior_box_;
    QLabel* help_label_;
    AreaForm* area_form_;
    QToolButton* area_tool_;
    QLabel* summary_label_;
    QPushButton* start_;
    QPushButton* pause_;
    QPushButton* land_;
    QPushButton* stop_;
    std::optional<RunState> run_state_;
};

} // namespace usar::widgets
