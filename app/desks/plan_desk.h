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
    explicit PlanDesk(const DeskContext& context);

    void registerCommands() override;
    void wire() override;
    void restore(const QSettings& settings) override { breakpoints_.restore(settings); }
    void save(QSettings& settings) const override { breakpoints_.save(settings); }

    /// The robot's behavior is started again: its pins are removed.
    void begin(RobotId id);

    /// True if the plan of a live robot is halted.
    bool anyHalted() const;
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

    void take(RobotId id, const mission::SessionUpdate& update);
    void takeNews(RobotId id, const agent::PlanHalted& halted);
    void takeNews(RobotId id, const agent::PlanResumed&);
    void takeNews(RobotId id, const agent::PlanReplaced& replaced);
    void takeNews(RobotId, const auto&) {}

    void select();
    void showHalt();
    void showMarks();
    void openMenu(widgets::PlanNodeId node, const QPoint& at);
    void chooseWhereToSavePicture();
    void stepEpoch();
    void pinSelected();
    void toggleDrive();
    void pinsChanged();

    PlanRunDesk run_;
    BreakpointDesk breakpoints_;
    std::map<ConnectionId, widgets::PlanPins> pins_; ///< by connection
    bool epoch_wanted_ = false;                      ///< the next halt is shown at the first epoch of its cycle
    bool stepping_ = false;                          ///< plans run for one cycle only
};

} // namespace usar::app
