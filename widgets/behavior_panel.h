// What the selected robot should do: behavior, mission area, parameters, and the buttons that make it so.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include <QWidget>

#include "core/agent/robot_plugin.h"
#include "core/base/geometry.h"
#include "widgets/area_form.h"
#include "widgets/plan_choice.h"

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace usar::widgets {

/// What the buttons may do now.
enum class RunState { NoRobot, Ready, Running, Paused, Replay };

/// Forwards intent as signals and shows what it is told; decides nothing. Lives in the GUI thread.
class BehaviorPanel : public QWidget {
    Q_OBJECT
public:
    /// `parameter_form` is shown below the area; the panel becomes its parent.
    explicit BehaviorPanel(QWidget* parameter_form, QWidget* parent = nullptr);

    /// Keeps the chosen one if it is among them. Emits behaviorChosen only when another one is chosen by it.
    void setBehaviors(const std::vector<agent::BehaviorDescription>& behaviors);
    /// Tells as if the person had chosen it; an unknown id changes nothing.
    void chooseBehavior(const std::string& id);
    /// Empty when there is none.
    std::string behaviorId() const;

    /// Of the chosen behavior; hidden where no plan decides.
    PlanChoice& plan() { return *plan_; }
    const PlanChoice& plan() const { return *plan_; }
    bool needsArea() const;
    /// The chosen behavior is to run in a process of its own. Setting it is silent.
    bool isolated() const;
    void setIsolated(bool isolated);

    /// Nothing: not drawn yet. A behavior that needs no area hides it.
    void setArea(const std::optional<Rectangle>& area_in_map) { area_form_->setArea(area_in_map); }
    void setAreaLimits(const Rectangle& world_in_map) { area_form_->setLimits(world_in_map); }
    /// The extent of a real server's world is not known.
    void clearAreaLimits() { area_form_->clearLimits(); }
    Rectangle area() const { return area_form_->area(); }
    /// "5 lanes · 312 m · 6 min 10 s", or why there are none.
    void setPlanSummary(const QString& summary);
    /// True when this changed what the buttons may do.
    bool setRunState(RunState state, const QString& robot_name);
    /// Shows that the map's area tool is in hand; no signal.
    void setAreaToolActive(bool active);
    /// From now on the buttons trigger these actions, follow their enabled state and name their shortcuts; the signals
    /// of the same meaning fall silent. A null action leaves its button as it is. They outlive the panel or go with it.
    void setActions(QAction* start, QAction* pause, QAction* land, QAction* stop);
    /// Shown as a button beside the list of behaviors.
    void setRescanAction(QAction* action);

signals:
    /// By the person, or because the list or chooseBehavior changed it.
    void behaviorChosen(const QString& id);
    /// Empty where the typed values enclose nothing.
    void areaTyped(const usar::Rectangle& area_in_map);
    /// The person wants to draw, or has had enough of it.
    void areaToolToggled(bool active);
    /// By the person.
    void isolationChosen(bool isolated);
    void startRequested();
    /// False: go on. The button shows the new state only when setRunState says so.
    void pauseRequested(bool paused);
    void landRequested();
    void stopRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void showBehavior();
    /// Where there is no room for all, the help is in the list's tooltip alone.
    void fitHelp();
    void makeAreaBox();
    QWidget* makeButtons();
    std::array<QPushButton*, 4> buttons() const;
    void press(QPushButton* button);
    bool mayPress(const QPushButton* button) const;
    /// Hands the focus to another button before it switches off the one that has it.
    void enable(QPushButton* button, bool on);
    bool busy() const;

    std::vector<agent::BehaviorDescription> behaviors_; ///< row by row
    QLabel* robot_label_;
    QComboBox* behavior_box_;
    QToolButton* rescan_;
    QLabel* help_label_;
    QCheckBox* isolated_;
    PlanChoice* plan_;
    QWidget* area_box_;
    AreaForm* area_form_;
    QToolButton* area_tool_;
    QLabel* summary_label_;
    QPushButton* start_;
    QPushButton* pause_;
    QPushButton* land_;
    QPushButton* stop_;
    std::map<QPushButton*, QAction*> actions_; ///< of those buttons that an action drives
    std::optional<RunState> run_state_;
};

} // namespace usar::widgets
