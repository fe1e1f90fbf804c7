// Panel that says what the selected robot should do: behavior, mission area, parameters, and the buttons that run it.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QWidget>

#include "core/agent/robot_plugin.h"
#include "core/base/geometry.h"
#include "widgets/panels/behavior_parts.h"
#include "widgets/panels/quantity_box.h"
#include "widgets/style/form_parts.h"

class QAction;

namespace usar::widgets {

class ScrollBox;

/// State of the selected robot's behavior.
enum class RunState { NoRobot, Ready, Running, Paused, Replay };

/// Reports the user's wishes as signals and shows the state it is given; makes no decisions itself. GUI thread.
class BehaviorPanel : public QWidget {
    Q_OBJECT
public:
    /// `parameter_form` is shown below the area; the panel becomes its parent.
    explicit BehaviorPanel(QWidget* parameter_form, QWidget* parent = nullptr);

    /// Keeps the current choice if it is among them, else chooses the first. Emits behaviorChosen only if the choice
    /// changed.
    void setBehaviors(const std::vector<agent::BehaviorDescription>& behaviors);
    /// Chooses and emits behaviorChosen as if the user had done it; an unknown id changes nothing.
    void chooseBehavior(const std::string& id);
    /// Id of the chosen behavior; empty if the list is empty.
    std::string behaviorId() const { return behavior_box_->currentData().toString().toStdString(); }

    /// The plan of the chosen behavior; the widget is hidden for behaviors without a plan.
    PlanChoice& plan() { return *plan_; }
    const PlanChoice& plan() const { return *plan_; }
    /// True if the chosen behavior needs a mission area, and if none is chosen.
    bool needsArea() const;
    /// True if the chosen behavior should run in a process of its own. Setting it emits nothing.
    bool isolated() const { return isolated_->isChecked(); }
    void setIsolated(bool isolated) { isolated_->setChecked(isolated); }
    /// True if the height map is to be corrected where its strips overlap. Setting it emits nothing.
    bool adjusts() const { return adjust_->isChecked(); }
    void setAdjust(bool adjust) { adjust_->setChecked(adjust); }
    /// Hours of simulated time after which the behavior is ended; nullopt: never. Setting it emits nothing.
    std::optional<double> limit_h() const;
    void setLimit(const std::optional<double>& hours);

    /// Area in meters of the map frame; nullopt: not drawn yet. Emits nothing. The form is hidden for behaviors that
    /// need no area.
    void setArea(const std::optional<Rectangle>& area_in_map) { area_form_->setArea(area_in_map); }
    /// Values outside the world's extent are marked in the form; an empty rectangle removes the limit, for real
    /// servers, which do not tell the extent of their world.
    void setAreaLimits(const Rectangle& world_in_map) { area_form_->setLimits(world_in_map); }
    /// The typed area, corners in order; empty() if they enclose nothing.
    Rectangle area() const { return area_form_->area(); }
    /// "5 lanes · 312 m · 6 min 10 s", or why there are no lanes; empty hides the line.
    void setPlanSummary(const QString& summary);
    /// Shows the state; locks the choice of a behavior while one runs. Returns true if the state changed.
    bool setRunState(RunState state, const QString& robot_name);
    /// Shows whether the map's area tool is active; emits nothing.
    void setAreaToolActive(bool active) { area_tool_->setChecked(active); }
    /// Connects the buttons with these actions: from now on they trigger them, follow their visibility and enabled
    /// state, and show their shortcuts; until then they are disabled. Pause shows a new state only when setRunState
    /// reports it. The actions must live as long as the panel, or be destroyed with it. To be called once.
    void setActions(QAction* start, QAction* pause, QAction* land, QAction* stop);
    /// Shows this action as a button beside the list of behaviors.
    void setRescanAction(QAction* action);

    /// True while the behavior runs or is paused.
    bool busy() const { return run_state_ == RunState::Running || run_state_ == RunState::Paused; }
    // What the tour points at.
    QComboBox* choice() const { return behavior_box_; }
    QToolButton* areaTool() const { return area_tool_; }
    QPushButton* startButton() const { return start_; }

signals:
    /// By the user, or because setBehaviors or chooseBehavior changed the choice.
    void behaviorChosen(const QString& id);
    /// By the user; an empty rectangle if the typed values enclose nothing.
    void areaTyped(const usar::Rectangle& area_in_map);
    /// The user wants to start (true) or stop (false) drawing the area on the map.
    void areaToolToggled(bool active);
    /// By the user only.
    void isolationChosen(bool isolated);
    void adjustChosen(bool adjust);
    void limitChosen(std::optional<double> hours);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void showBehavior();
    /// Hides the help line if there is no room for it; the list's tooltip still has it.
    void fitHelp();
    void makeAreaBox();
    QLayout* makeLimitRow();
    /// Locks what cannot change while a behavior runs.
    void lockChoices();
    QWidget* makeButtons();
    std::array<QPushButton*, 4> buttons() const { return {start_, pause_, land_, stop_}; }
    /// Enables or disables the button as its action is. Moves the focus to another button before the one that has it is
    /// disabled.
    void follow(QPushButton* button, const QAction* action);

    std::vector<agent::BehaviorDescription> behaviors_; ///< in the order of the list
    QWidget* content_ = new QWidget;                    ///< all but the buttons
    ScrollBox* scroll_ = nullptr;                       ///< holds `content_`
    QLabel* robot_label_ = new QLabel;
    QComboBox* behavior_box_ = new QComboBox;
    QToolButton* rescan_ = new QToolButton;
    QLabel* help_label_ = mutedLabel();
    QCheckBox* isolated_ = new QCheckBox(tr("Run in a separate process"));
    QCheckBox* adjust_ = new QCheckBox(tr("Correct the map where strips overlap"));
    QuantityBox* limit_ = new QuantityBox;
    PlanChoice* plan_ = new PlanChoice;
    QWidget* area_box_ = new QWidget;
    AreaForm* area_form_ = new AreaForm;
    QToolButton* area_tool_ = new QToolButton;
    QLabel* summary_label_ = mutedLabel();
    QPushButton* start_ = new QPushButton(tr("Start"));
    QPushButton* pause_ = new QPushButton(tr("Pause"));
    QPushButton* land_ = new QPushButton(tr("Land now"));
    QPushButton* stop_ = new QPushButton(tr("Stop"));
    std::optional<RunState> run_state_; ///< nullopt until the first setRunState
};

} // namespace usar::widgets
