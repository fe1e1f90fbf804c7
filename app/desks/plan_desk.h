// Desk of the plan dock: shows what the robots' plans do and did, and lets the user debug them.
#pragma once

#include <map>
#include <vector>

#include <QObject>
#include <QSettings>

#include "app/desks/desk.h"
#include "app/desks/plan_watch.h"
#include "widgets/models/plan/breakpoint_list.h"

namespace usar::app {

/// Shows the plan of the selected robot, now or at an earlier moment. Breakpoints belong to a plan, by its name, and
/// are kept in the settings; pins belong to one run of one robot. GUI thread.
class PlanDesk : public QObject {
    Q_OBJECT
public:
    explicit PlanDesk(const DeskContext& context);

    void registerCommands();
    /// To be called after all commands are registered.
    void wire();
    void restore(const QSettings& settings);
    void save(QSettings& settings) const;

    /// Removes the pins of this robot, because its behavior was started again.
    void begin(int id);

    /// True if the plan of any running behavior is halted; replays do not count.
    bool anyHalted() const;
    /// Continues all halted plans.
    void goOn();
    /// Runs one cycle of the selected robot's plan, and of the other halted plans whose robots share its server's time.
    void stepCycle();
    const widgets::BreakpointList& breakpoints() const { return list_; }

signals:
    /// The selected robot has another plan, or another text of it; empty: none.
    void planShown(const std::string& text);
    /// False: a plan was halted, so the embedded simulator's time should stop. True: no plan is halted any longer.
    void timeWanted(bool runs);
    /// Simulated time should run until a plan is halted again.
    void cycleWanted();

private:
    /// A place of the shown plan, as breakpoints and pins refer to it.
    struct PlanSpot {
        std::string path;
        std::string names;
        std::string call; ///< as in traces; empty unless it is a sense or an act
        posh::PlaceKind kind = posh::PlaceKind::Collection;
    };

    void take(int id, const mission::SessionUpdate& update);
    void select(int id);
    /// Sends the breakpoints to a new robot.
    void welcome(int id);
    void chooseWhereToSavePicture();

    void registerPictureCommand();
    void registerBreakpointCommands();
    void registerRunCommands();
    void registerPinCommands();
    void registerTimeCommands();

    Robot* robot() const { return control_.robot(selected_); }
    /// The watch of the selected robot.
    PlanWatch& watch();
    void show(PlanWatch::News news);
    void showTime();
    void showHalt();
    void showMarks();
    void showBreakpoints();
    void openMenu(int node, const QPoint& at);
    /// The places of the selected card; more than one if it is drawn once for several places.
    std::vector<PlanSpot> selectedSpots();
    /// True if a card of one of these kinds is selected; an empty list means any kind.
    bool selectedIs(std::initializer_list<widgets::PlanNodeKind> kinds) const;
    /// Ids of the breakpoints at the selected card, of this type or of any.
    std::vector<int> breakpointsSelected(std::optional<posh::BreakOn> on = std::nullopt);

    // These take what the behavior of a live robot has published.
    void takeNews(int id, const agent::PlanHalted& halted);
    void takeNews(int id, const agent::PlanResumed&);
    void takeNews(int id, const agent::PlanReplaced& replaced);
    void takeNews(int, const auto&) {}

    /// Removes the breakpoints of this type at the selected card, or sets one if there is none.
    void toggleBreakpoint(posh::BreakOn on);
    /// Does the same for the selected key of the blackboard.
    void toggleKeyBreakpoint();
    void editBreakpoint(int id);
    void editSelected();
    void switchSelected();
    void switchBreakpoint(int id, bool on);
    /// Sends the list to all robots and shows it.
    void breakpointsChanged();
    /// Continues until the selected card is reached.
    void runToSelected();
    /// Removes the breakpoints of "run to here".
    void dropTemporary();
    /// Shows the next epoch of the shown cycle; after the last one, runs one more cycle.
    void stepEpoch();
    /// Asks for the answer to pin to the selected sense or act, or removes its pin.
    void pinSelected();
    void toggleDrive();
    /// Sends the pins to the selected robot and shows them.
    void pinsChanged();
    /// Shows the plan at this time (protocol clock); a replay goes there as a whole.
    void goTo(Seconds time);
    void stepBy(int cycles);
    void showReport();
    void saveReport(const QString& path, const posh::RunStatistics& statistics);
    void lookBack();
    void backToNow();
    /// Why the selected robot's past cannot be replayed while it continues; empty: it can.
    QString whyNoLookBack() const;
    void showLookBack();

    MissionControl& control_;
    WindowViews& views_;
    widgets::CommandRegistry& commands_;
    Selection& selection_;
    NoticeDesk& notices_;
    QWidget* window_;
    int selected_ = 0;
    std::map<int, PlanWatch> watches_;   ///< by connection
    std::map<int, agent::SetPins> pins_; ///< by connection
    widgets::BreakpointList list_;
    std::vector<int> temporary_; ///< ids of the breakpoints of "run to here"
    bool epoch_wanted_ = false;  ///< the next halt is shown at the first epoch of its cycle
    bool stepping_ = false;      ///< the plans run for one cycle only
    QString no_look_back_;       ///< result of `whyNoLookBack` that the button shows
    QString look_back_help_;     ///< the button's tooltip while it is enabled
};

} // namespace usar::app
