// Brings runs of a campaign back on the screen: flies one in the window, or replays two of one seed beside each other.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>

#include "app/desks/desk.h"
#include "app/desks/server_desk.h"
#include "app/desks/task_desk.h"
#include "core/campaign/runs/run_process.h"
#include "core/mission/files/mission_options.h"

namespace usar::app {

/// A run as its command says it is flown.
struct RunOrder {
    mission::Mission mission; ///< It has the values, behavior and plan of the command; its faults are in `faults`.
    std::uint64_t seed = 1;
    std::vector<sim::Fault> faults; ///< They are those of the mission and of the command.
};

/// The command that flies the run from any folder: it has the whole path of a mission that is named from the campaign's
/// `folder`.
Result<QString> wholeCommandOf(const campaign::RunResult& run, const QString& folder);

/// Reads the command of a result line and the mission that it names. `folder` is that of the campaign's results.
/// Errors name the file and the place.
Result<RunOrder> orderOf(const campaign::RunResult& run, const QString& folder);

/// A run is flown in a new embedded simulator of its seed, whose time begins with the robot; its behavior starts with
/// the robot's first line. All of this is as in usar-mission, so that the flight is the same. GUI thread.
class RunFlights : public Desk {
    Q_OBJECT
public:
    RunFlights(const DeskContext& context, ServerDesk& server, TaskDesk& task)
        : Desk(context)
        , server_(server)
        , task_(task) {}
    ~RunFlights() override;

    void wire() override;
    /// Leaves the present world and flies the run in the window.
    void fly(const campaign::RunResult& run, const QString& folder);
    /// Flies two runs again in the background with recordings, into `folder`, which is the campaign's; then both are
    /// replayed as robots beside each other, with one time, and their figures and maps are compared.
    void flyPair(const campaign::RunResult& first, const campaign::RunResult& second, const QString& folder);
    /// True while two runs are being flown in the background.
    bool flyingPair() const { return pair_ != nullptr; }

signals:
    /// These replays show one seed, and are to have one time.
    void togetherWanted(const std::vector<usar::RobotId>& replays);
    /// A pair is flown now, or no longer.
    void pairChanged();

private:
    /// One of the two runs that are flown again.
    struct Side {
        campaign::RunProcess process;
        QString variant;
        QString title;     ///< It tells the run from the other one: "POSH, seed 3".
        QString recording; ///< It is the path of a file.
        QString summary;   ///< It is the path of a file, and empty until the run has ended.
    };
    struct Pair {
        std::array<Side, 2> sides;
        int under_way = 2;
    };

    void begin(const protocol::StartPoses& poses);
    void start(Side& side, const QStringList& arguments, const QString& folder);
    void takeEnd(Side& side, const campaign::ProcessEnd& end);
    /// Both runs of the pair have ended.
    void showPair();
    void takeReplay(RobotId id);

    ServerDesk& server_;
    TaskDesk& task_;
    std::optional<RunOrder> awaited_; ///< It is flown as soon as its world is there.
    QString awaited_name_;
    std::unique_ptr<Pair> pair_;
    std::map<QString, QString> awaited_replays_; ///< These are variants, by the recordings that are being opened.
    std::vector<RobotId> replays_;               ///< They show the newest pair.
    QStringList replay_words_;                   ///< They say which replay is which variant.
};

} // namespace usar::app
