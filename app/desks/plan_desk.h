// The plan's part of the window: halts of robots' plans, steps, and what a user pins in a run.
#pragma once

#include <map>

#include "app/desks/breakpoint_desk.h"
#include "app/desks/desk.h"
#include "app/desks/plan_run_desk.h"
#include "widgets/models/plan/plan_spots.h"

namespace usar::app {

/// Owns the desks of runs and breakpoints, and brings what they know together in the marks of the drawing. Pins belong
/// to one run of one robot. GUI thread.
class PlanDesk : public Desk {
    Q_OBJECT
public:
    explicit PlanDesk(const DeskContext& context) : Desk(context), run_(context), breakpoints_(context, run_) {}

    void registerCommands() override;
    void wire() override;
    void restore(const QSettings& settings) override { breakpoints_.restore(settings); }
    void save(SettingsSheet& settings) const override { breakpoints_.save(settings); }

    /// The robot's behavior is started again: its pins are removed.
    void begin(RobotId id);

    /// True if the plan of a live robot is halted.
    bool anyHalted() const { return mission::anyHalted(control_.robots()); }
    /// Continues all halted plans.
    void goOn();
    /// Runs one cycle of the selected robot's plan, and of the plans whose server's time waits for it.
    void stepCycle();

signals:
    /// The selected robot's plan has changed; an empty text means that it has none.
    void planShown(const std::string& text);
    /// False: a plan is halted, and the embedded simulator's time should stop, too. True: no plan is halted any longer.
    void timeWanted(bool runs);
    /// Time should run until a plan is halted again.
    void cycleWanted();

private:
    void registerRunCommands();
    void registerPinCommands();
    /// For the palette: the parts of the shown plan, to go to.
    std::vector<widgets::PaletteOffer> places() const;

    /// Takes the update of any robot, so that halts are noticed even of robots that are not selected.
    void take(RobotId id, const mission::SessionUpdate& update);
    /// Stops the time; a halt at a breakpoint is also a notification.
    void takeNews(RobotId id, const agent::PlanHalted& halted);
    /// Lets the time run again, unless another plan is halted or plans run for one cycle only.
    void takeNews(RobotId id, const agent::PlanResumed&);
    /// Says whether the robot continues, begins at the root, or refuses the new plan, and why.
    void takeNews(RobotId id, const agent::PlanReplaced& replaced);
    void takeNews(RobotId, const auto&) {}

    void select();
    /// Shows where and why the selected robot's plan is halted; empties the bar if it is not.
    void showHalt();
    /// Collects the marks of breakpoints, pins and the halt for the drawing.
    void showMarks();
    /// Opens the context menu of a part, without the commands that its kind does not allow.
    void openMenu(widgets::PlanNodeId node, const QPoint& at);
    /// Saves the drawing as SVG, PDF or PNG; the result is a notice.
    void chooseWhereToSavePicture();
    /// Shows the next epoch of the halted cycle; after the last one, runs another cycle and shows its first epoch.
    void stepEpoch();
    /// Releases the selected part's pin if it has one; otherwise asks for the value or result to pin.
    void pinSelected();
    /// Switches the selected drive off or on for this run.
    void toggleDrive();
    /// Sends the pins to the selected robot.
    void pinsChanged();

    PlanRunDesk run_;
    BreakpointDesk breakpoints_;
    std::map<ConnectionId, widgets::PlanPins> pins_; ///< by connection
    bool epoch_wanted_ = false;                      ///< the next halt is shown at the first epoch of its cycle
    bool stepping_ = false;                          ///< plans run for one cycle only
};

} // namespace usar::app
