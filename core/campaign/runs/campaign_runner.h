// Flies the runs of a campaign, several at a time, and writes each result as it comes.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <QElapsedTimer>
#include <QObject>

#include "core/campaign/runs/run_process.h"
#include "core/campaign/runs/shard_file.h"

namespace usar::campaign {

/// Says where and how the runs are flown.
struct RunnerOptions {
    QString program; ///< path of usar-mission
    QString folder;  ///< of the campaign's results
    Shard shard;
    int jobs = 1; ///< processes at a time
    /// One run in so many is flown twice and must come out the same; 0: none. The first run is one of them.
    int check_every = 100;
    std::string version; ///< of the program
};

/// Counts of a campaign, of the runs of this shard only.
struct CampaignProgress {
    int runs = 0;                    ///< all of them
    int done = 0;                    ///< They have a result, from earlier or now.
    int flown = 0;                   ///< They were flown by this runner.
    std::map<Outcome, int> outcomes; ///< how many results of each kind there are
    std::vector<int> different;      ///< numbers of runs that were flown twice with different results, ascending
    std::vector<int> unsound; ///< numbers of runs that break an invariant, ascending; those that differ are among them
    Seconds wall{0.0};
    /// Results that are not Outcome::Done.
    int failures() const;
    /// Runs per second of wall time; 0 before the first has ended.
    double rate_hz() const { return wall.count() > 0.0 ? flown / wall.count() : 0.0; }
};

/// Takes the runs in the order of their numbers. A result is written before the next run takes its place, so that
/// whatever ends this program, only runs that were under way are flown again. Lives in its owner's thread, which needs
/// an event loop.
class CampaignRunner : public QObject {
    Q_OBJECT
public:
    /// `earlier`: results that are there already; their runs are not flown again.
    CampaignRunner(Campaign campaign, std::vector<PlannedRun> runs, std::vector<RunResult> earlier,
                   RunnerOptions options, ShardFile results);
    ~CampaignRunner() override;

    void start();
    /// Stops the runs under way; `finished` follows.
    void interrupt();
    /// Starts no more runs; `finished` follows when those under way have ended.
    void startNoMore() { waiting_.clear(); }
    CampaignProgress progress() const;
    const Campaign& campaign() const { return campaign_; }
    const std::vector<RunResult>& earlier() const { return earlier_; }
    /// The runs that break an invariant, with what they break, in the order in which they ended.
    const std::vector<std::pair<PlannedRun, RunResult>>& unsound() const { return unsound_; }
    /// Set if the results could not be written.
    const std::optional<Error>& trouble() const { return trouble_; }

signals:
    void ran(const usar::campaign::RunResult& result);
    void finished();

private:
    struct Flight;

    void startNext();
    std::unique_ptr<RunProcess> takeProcess(bool again);
    void fly(std::unique_ptr<Flight> flight);
    void take(Flight& flight, const ProcessEnd& end);
    void count(const PlannedRun& run, const RunResult& result);

    Campaign campaign_;
    std::vector<PlannedRun> waiting_; ///< the next one last
    std::vector<RunResult> earlier_;
    RunnerOptions options_;
    ShardFile file_;
    std::map<int, std::unique_ptr<Flight>> flying_; ///< by the number of the run
    std::vector<std::unique_ptr<RunProcess>> idle_; ///< workers that have nothing to fly
    CampaignProgress progress_;
    std::vector<std::pair<PlannedRun, RunResult>> unsound_;
    QElapsedTimer since_start_;
    bool interrupted_ = false;
    std::optional<Error> trouble_;
};

} // namespace usar::campaign
