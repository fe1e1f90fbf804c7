// The plan's part of the window: what robots' plans do and did, and what a person does to them.
#pragma once

#include <map>
#include <vector>

#include <QObject>
#include <QSettings>

#include "app/desks/desk.h"
#include "app/desks/plan_watch.h"
#include "widgets/models/plan/breakpoint_list.h"

namespace usar::app {

/// Breakpoints belong to plans, by their names, and are kept over restarts; what is pinned belongs to one run of one
/// robot. GUI thread.
class PlanDesk : public QObject {
    Q_OBJECT
public:
    explicit PlanDesk(const DeskContext& context);

    void registerCommands();
    /// Once commands are registered.
    void wire();
    void restore(const QSettings& settings);
    void save(QSettings& settings) const;

    /// The robot's behavior is started again: nothing is pinned.
    void begin(int id);

    /// Of robots that fly.
    bool anyHalted() const;
    /// All that stand still.
    void goOn();
    /// The selected one, and those whose time waits for it.
    void stepCycle();
    const widgets::BreakpointList& breakpoints() const { return list_; }

signals:
    /// The selected robot's plan is another one; empty: it has none.
    void planShown(const std::string& text);
    /// A plan stands still, and our simulator's time should, too; or none does any more.
    void timeWanted(bool runs);
    /// Time should run until a plan stands still again.
    void cycleWanted();

private:
    /// A place of the shown plan, with what breakpoints and pins name it by.
    struct PlanSpot {
        std::string path;
        std::string names;
        std::string call; ///< of senses and acts
        posh::PlaceKind kind = posh::PlaceKind::Collection;
    };

    void take(int id, const mission::SessionUpdate& update);
    void select(int id);
    /// A robot was spawned: breakpoints are meant for it, too.
    void welcome(int id);
    void chooseWhereToSavePicture();

    void registerPictureCommand();
    void registerBreakpointCommands();
    void registerRunCommands();
    void registerPinCommands();
    void registerTimeCommands();

    Robot* robot() const { return control_.robot(selected_); }
    PlanWatch& watch();
    void show(PlanWatch::News news);
    void showTime();
    void showHalt();
    void showMarks();
    void showBreakpoints();
    void openMenu(int node, const QPoint& at);
    /// More than one where a part that is used at several places is drawn once.
    std::vector<PlanSpot> selectedSpots();
    bool selectedIs(std::initializer_list<widgets::PlanNodeKind> kinds) const;
    std::vector<int> breakpointsSelected(std::optional<posh::BreakOn> on = std::nullopt);

    void takeNews(int id, const agent::PlanHalted& halted);
    void takeNews(int id, const agent::PlanResumed&);
    void takeNews(int id, const agent::PlanReplaced& replaced);
    void takeNews(int, const auto&) {}

    void toggleBreakpoint(posh::BreakOn on);
    void toggleKeyBreakpoint();
    void editBreakpoint(int id);
    void editSelected();
    void switchSelected();
    void switchBreakpoint(int id, bool on);
    void breakpointsChanged();
    void runToSelected();
    void dropTemporary();
    void stepEpoch();
    void pinSelected();
    void toggleDrive();
    void pinsChanged();
    void goTo(Seconds time);
    void stepBy(int cycles);
    void showReport();
    void saveReport(const QString& path, const posh::RunStatistics& statistics);
    void lookBack();
    void backToNow();
    /// Why what is shown cannot be replayed while it goes on; empty: it can.
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
    std::vector<int> temporary_; ///< breakpoints of "run to here"
    bool epoch_wanted_ = false;  ///< the next halt is shown at its first epoch
    bool stepping_ = false;      ///< it goes on for one cycle only
    QString no_look_back_;       ///< why, as the button says it
    QString look_back_help_;     ///< what it says otherwise
};

} // namespace usar::app
