#include "core/campaign/runs/campaign_runner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QDir>
#include <QFile>
#include <QJsonArray>

#include "core/campaign/runs/invariants.h"
#include "core/mission/runs/mission_runner.h"

namespace usar::campaign {

namespace {

/// Returns sentences about the files that a run could not write into its folder. Deletes those that it has put into the
/// folder for temporary files instead, because nobody would look for them there.
QStringList takeUnwritten(const QJsonObject& summary, const QString& folder) {
    QStringList sentences;
    for (const QJsonValue sentence : summary["unwritten"].toArray())
        sentences << sentence.toString();
    if (sentences.isEmpty())
        return sentences;
    const QString own = QDir(folder).absolutePath() + '/';
    const QString shelter = QDir::tempPath() + mission::shelter_name + '/';
    for (const QJsonValue file : summary["files"].toArray())
        if (const QString path = file.toString(); !path.startsWith(own) && path.startsWith(shelter))
            QFile::remove(path);
    return sentences;
}

/// Runs end in another order each time, and what is told of them shall be the same.
void insertSorted(int number, std::vector<int>& numbers) {
    numbers.insert(std::ranges::upper_bound(numbers, number), number);
}

} // namespace

struct CampaignRunner::Flight {
    PlannedRun run;
    RunResult result;
    bool again = false; ///< it is flown for the second time
    QString folder;     ///< of its result files
    std::unique_ptr<RunProcess> process{};
};

int CampaignProgress::failures() const {
    const auto successes = outcomes.find(Outcome::Done);
    return done - (successes == outcomes.end() ? 0 : successes->second);
}

CampaignRunner::CampaignRunner(Campaign campaign, std::vector<PlannedRun> runs, std::vector<RunResult> earlier,
                               RunnerOptions options, ShardFile results)
    : campaign_(std::move(campaign))
    , earlier_(std::move(earlier))
    , options_(std::move(options))
    , file_(std::move(results)) {
    std::map<int, const RunResult*> known;
    for (const RunResult& result : earlier_)
        known[result.number] = &result;
    for (PlannedRun& run : runs) {
        if (!options_.shard.has(run))
            continue;
        ++progress_.runs;
        const auto found = known.find(run.number);
        if (found == known.end())
            waiting_.push_back(std::move(run));
        else
            count(run, *found->second);
    }
    std::ranges::reverse(waiting_);
}

CampaignRunner::~CampaignRunner() = default;

void CampaignRunner::start() {
    since_start_.start();
    for (int i = 0; i < options_.jobs; ++i)
        startNext();
}

void CampaignRunner::interrupt() {
    interrupted_ = true;
    waiting_.clear();
    for (const auto& [number, flight] : flying_)
        flight->process->stop();
    if (flying_.empty())
        emit finished();
}

CampaignProgress CampaignRunner::progress() const {
    CampaignProgress progress = progress_;
    progress.wall = Seconds{since_start_.isValid() ? static_cast<double>(since_start_.nsecsElapsed()) * 1e-9 : 0.0};
    return progress;
}

void CampaignRunner::startNext() {
    if (waiting_.empty()) {
        if (flying_.empty())
            QMetaObject::invokeMethod(this, &CampaignRunner::finished, Qt::QueuedConnection);
        return;
    }
    auto flight = std::make_unique<Flight>();
    flight->run = std::move(waiting_.back());
    waiting_.pop_back();
    const PlannedRun& run = flight->run;
    RunResult& result = flight->result;
    result.number = run.number;
    result.pair = run.pair;
    result.mission = nameOf(campaign_.missions[run.mission]).toStdString();
    result.variant = campaign_.variants[run.variant].name;
    result.seed = run.seed;
    result.version = options_.version;
    result.command = commandOf(campaign_, run);
    if (campaign_.limit_h)
        result.limit_s = *campaign_.limit_h * 3600.0;
    fly(std::move(flight));
}

/// A run that is flown again to be compared has a worker of its own, which begins with other addresses.
std::unique_ptr<RunProcess> CampaignRunner::takeProcess(bool again) {
    if (again)
        return std::make_unique<RunProcess>();
    if (idle_.empty())
        return std::make_unique<RunProcess>(RunProcess::Worker::FliesMore);
    auto process = std::move(idle_.back());
    idle_.pop_back();
    return process;
}

void CampaignRunner::fly(std::unique_ptr<Flight> flight) {
    Flight& one = *flight;
    one.folder = runFolder(options_.folder, one.run.number) + (one.again ? "-again" : "");
    QDir(one.folder).removeRecursively(); // An interrupted campaign may have left some of its files.
    QDir().mkpath(one.folder);
    QStringList arguments = flightArgumentsOf(campaign_, one.run, one.folder);
    if (campaign_.keep == Keep::Everything && !one.again)
        arguments << "--record" << QDir(one.folder).filePath("run.usarrec");
    one.process = takeProcess(one.again);
    connect(
        one.process.get(), &RunProcess::ended, this, [this, &one](const ProcessEnd& end) { take(one, end); },
        static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection)); // It may be started again.
    flying_[one.run.number] = std::move(flight);
    one.process->start(options_.program, arguments, Seconds{campaign_.wall_limit_s});
}

void CampaignRunner::take(Flight& flight, const ProcessEnd& end) {
    const auto owned = std::move(flying_.extract(flight.run.number).mapped());
    const Seconds wall = flight.process->wall();
    if (!flight.again)
        idle_.push_back(std::move(flight.process));
    if (end.stopped) {
        QDir(flight.folder).removeRecursively();
        return startNext();
    }
    RunResult now = flight.result;
    now.wall_s = std::round(wall.count() * 1000.0) / 1000.0;
    judge(now, end);
    if (const QStringList unwritten = takeUnwritten(now.summary, flight.folder); !unwritten.isEmpty()) {
        QDir(flight.folder).removeRecursively();
        trouble_ = {"what is kept of a run cannot be written: " + unwritten.join(' ').toStdString(),
                    flight.folder.toStdString(), "Make room and go on with --resume; this run will be flown again"};
        return interrupt();
    }
    const bool is_cut = now.outcome == Outcome::TimedOut || now.outcome == Outcome::Killed;
    const bool checked = options_.check_every > 0 && flight.run.number % options_.check_every == 0;
    if (checked && !flight.again && !is_cut && !interrupted_) {
        auto again = std::make_unique<Flight>(Flight{flight.run, std::move(now), true, {}, {}});
        return fly(std::move(again));
    }
    if (flight.again) {
        QDir(flight.folder).removeRecursively();
        const RunResult second = std::exchange(now, flight.result);
        if (second.outcome != Outcome::Killed) // Otherwise nobody knows how it would have come out.
            now.differences =
                second.outcome == now.outcome ? differencesOf(now.summary, second.summary) : QStringList{"outcome"};
        flight.folder = runFolder(options_.folder, flight.run.number);
    }
    const bool kept =
        campaign_.keep == Keep::Everything || (campaign_.keep == Keep::Failures && now.outcome != Outcome::Done);
    if (!kept) {
        QDir(flight.folder).removeRecursively();
        now.summary.remove("files");
    }
    now.broken = brokenInvariants(now);
    if (auto written = file_.append(now); !written) {
        trouble_ = written.error();
        return interrupt();
    }
    ++progress_.flown;
    count(flight.run, now);
    emit ran(now);
    startNext();
}

void CampaignRunner::count(const PlannedRun& run, const RunResult& result) {
    ++progress_.done;
    ++progress_.outcomes[result.outcome];
    if (result.differences && !result.differences->isEmpty())
        insertSorted(result.number, progress_.different);
    if (!result.broken.isEmpty()) {
        insertSorted(result.number, progress_.unsound);
        unsound_.emplace_back(run, result);
    }
}

} // namespace usar::campaign
