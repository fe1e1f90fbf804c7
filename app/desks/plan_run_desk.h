// The runs of robots' plans, now and earlier, as the plan's panel shows them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/desks/desk.h"
#include "widgets/models/plan/plan_spots.h"
#include "widgets/models/plan/plan_watch.h"

namespace usar::app {

/// Shows the selected robot's plan as it runs, or at an earlier moment of its run, and reports on the run. It does not
/// connect itself to updates: PlanDesk passes them on, because it needs them, too. GUI thread.
class PlanRunDesk : public Desk {
    Q_OBJECT
public:
    using News = widgets::PlanWatch::News;

    using Desk::Desk;

    void registerCommands() override;
    void wire() override;

    /// Takes a robot's update; returns the parts that the panel has to show if this is the selected robot.
    News take(const Robot& robot, const mission::SessionUpdate& update);
    /// Shows the selected robot's plan from the beginning, or no plan.
    void select();
    /// Shows what is new in the selected robot's plan.
    void show(News news);
    /// Enables "Replay from here", or says in its tooltip why it is disabled.
    void showLookBack();
    /// Shows the newest cycle, or only its first epoch if it has several.
    void showNewest(bool first_epoch);
    /// Shows the next epoch of the shown cycle; returns false if there is none.
    bool stepEpoch();

    /// The run of the selected robot's plan.
    widgets::PlanWatch& watch() { return watches_[control_.connectionOf(selection_.id())]; }
    /// The places that the selected part of the drawing stands for.
    std::vector<widgets::PlanSpot> selectedSpots();
    /// True if a part of one of these kinds is selected in the drawing; an empty list means any kind.
    bool selectedIs(const std::vector<widgets::PlanNodeKind>& kinds) const;

signals:
    /// The panel shows another plan; an empty text means none.
    void planShown(const std::string& text);

private:
    void showTime();
    /// Moves a replay, with all views, to this protocol time; for a live robot only the plan's panel shows that moment.
    void goTo(Seconds time);
    /// Moves by so many cycles, forward or backward, from the one that is shown.
    void stepBy(int cycles);
    void showReport();
    void lookBack();
    /// Closes a replay that looks back on a running robot, and shows the newest cycle.
    void backToNow();
    /// Reason why the shown run cannot be replayed while it continues; empty if it can.
    QString whyNoLookBack() const;

    std::map<ConnectionId, widgets::PlanWatch> watches_; ///< by connection
    QString no_look_back_;                               ///< the reason that the button's tooltip gives now
};

} // namespace usar::app
