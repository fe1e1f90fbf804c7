#include "core/mission/runs/recorded_scan.h"

#include <limits>
#include <utility>
#include <variant>

#include <QDir>
#include <QEventLoop>
#include <QFileInfo>

#include "core/agent/published_text.h"
#include "core/base/numbers.h"
#include "core/link/replay.h"
#include "core/mission/runs/remaining_area.h"
#include "core/mission/session/scan_book.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/reader.h"

namespace usar::mission {

namespace {

/// Recordings that each continue the one before. Whoever is cut off more often gets an error.
constexpr int longest_chain = 64;

/// Returns the path, or, if nothing is there, that of a file of the same name beside the recording that names it:
/// recordings are moved together.
QString foundBeside(const QString& path, const QString& recording) {
    return QFileInfo::exists(path) ? path : QFileInfo(recording).dir().filePath(QFileInfo(path).fileName());
}

/// `chain`: number of recordings that led to this one.
Result<RecordedScan> playRecording(const QString& path, int chain, bool with_scans);

/// Plays one recording into a book of its own.
class ScanPlayer : private link::ReplayTaker {
public:
    ScanPlayer(std::unique_ptr<link::RecordingReader> recording, int chain, bool with_scans)
        : path_(QString::fromStdString(recording->path()))
        , chain_(chain)
        , with_scans_(with_scans)
        , book_(cellSizeOf(recording->survey()), notices_)
        , replayer_(std::move(recording), *this) {
        book_.keepScans(with_scans);
    }

    Result<RecordedScan> playMission();
    Result<RecordedMap> playMap();

private:
    void rewound() override {}
    void opened(std::string_view) override { book_.beginConnection(); }
    void closed(std::string_view) override {}
    void line(std::string_view text, LineNumber number) override;
    void sent(const link::Record& record) override { takeCommand(record.bytes); }
    void note(const link::Record& record) override;
    void quiet(bool) override {}

    /// Plays to the end.
    Result<void> play();
    void takeCommand(std::string_view text);
    void takeMission(std::string_view text);
    RecordedScan result();
    /// Which parts of this recording, and of those that it continues, the map lacks.
    std::string missingParts() const;

    const QString path_;
    const int chain_; ///< number of recordings that led to this one
    const bool with_scans_;
    QEventLoop loop_; ///< before the replayer, whose timer needs the event loop of this thread
    Notices notices_{[](const Notice&) {}};
    ScanBook book_;
    protocol::Reader reader_;
    RecordedScan recorded_;
    bool known_ = false; ///< a mission was noted
    std::optional<Error> trouble_;
    link::Replayer replayer_;
};

Result<void> ScanPlayer::play() {
    QObject::connect(&replayer_, &link::Replayer::ended, &loop_, &QEventLoop::quit, Qt::QueuedConnection);
    replayer_.setSpeed(std::numeric_limits<double>::infinity());
    replayer_.setPlaying(true);
    book_.passOn(true); // Nobody sees the map on the way.
    loop_.exec();
    book_.passOn(false);
    if (trouble_)
        return tl::unexpected(*trouble_);
    return {};
}

Result<RecordedMap> ScanPlayer::playMap() {
    if (const auto played = play(); !played)
        return tl::unexpected(played.error());
    book_.finishAdjustment();
    return RecordedMap{book_.snapshot(with_scans_), missingParts()};
}

Result<RecordedScan> ScanPlayer::playMission() {
    if (const auto played = play(); !played)
        return tl::unexpected(played.error());
    if (!known_)
        return failure("the recording does not tell which mission was flown", path_.toStdString(),
                       "Fly the mission again; recordings of this version can be continued");
    if (recorded_.flown.mission.area_in_map.empty())
        return failure("the mission has no area of which a part could be left", path_.toStdString(),
                       "Fly it again as a whole");
    return result();
}

void ScanPlayer::line(std::string_view text, LineNumber number) {
    reader_.continueAfter({number.value - 1});
    book_.take(reader_.read(text));
}

void ScanPlayer::takeCommand(std::string_view text) {
    if (!text.starts_with("INIT") && !text.starts_with("SET"))
        return;
    Diagnostics ignored;
    const protocol::Command command = protocol::readCommand(text.substr(0, text.find_last_not_of("\r\n") + 1), ignored);
    book_.takeSent(command);
    const auto* init = std::get_if<protocol::Init>(&command);
    if (!init)
        return;
    recorded_.robot_name = init->robot_name.text();
    if (const auto* pose = std::get_if<Pose>(&init->start))
        recorded_.start_in_map = *pose;
}

void ScanPlayer::note(const link::Record& record) {
    if (record.name == "robot") {
        takeCommand(record.bytes);
    } else if (record.name == "mission") {
        takeMission(record.bytes);
    } else if (record.name == "finished") {
        recorded_.finished = true;
    } else if (record.name == "published") {
        const auto value = agent::readPublished(record.bytes);
        if (!value)
            return;
        book_.take(*value);
        if (std::holds_alternative<agent::BehaviorFinished>(*value))
            recorded_.finished = true;
    }
}

void ScanPlayer::takeMission(std::string_view text) {
    auto flown = readFlownMission(text, path_);
    if (!flown) {
        trouble_ = flown.error();
        return;
    }
    known_ = true;
    recorded_.finished = false;
    recorded_.flown = *std::move(flown);
    const Mission& mission = recorded_.flown.mission;
    book_.setAdjust(mission.adjust);
    book_.setCellSize(mission.cell_size_m); // It may have been chosen after the recording began.
    if (const QString& before = recorded_.flown.continues; !before.isEmpty()) {
        const auto earlier = playRecording(foundBeside(before, path_), chain_ + 1, with_scans_);
        if (earlier) {
            book_.continueScan(earlier->scan);
            recorded_.missing = earlier->missing;
        } else {
            trouble_ = earlier.error();
        }
    }
    book_.beginTask(mission.behavior, recorded_.robot_name, mission.area_in_map);
}

std::string ScanPlayer::missingParts() const {
    const link::RecordingSurvey& survey = replayer_.survey();
    std::string here = survey.missingParts();
    if (!survey.not_read.empty())
        here += (here.empty() ? "" : " ") + survey.not_read;
    if (here.empty())
        return recorded_.missing;
    return (recorded_.missing.empty() ? "" : recorded_.missing + ' ') + QFileInfo(path_).fileName().toStdString() +
           ": " + here;
}

RecordedScan ScanPlayer::result() {
    book_.finishAdjustment();
    const ScanRecord& record = book_.record();
    const std::string missing = missingParts();
    RecordedScan result = std::move(recorded_);
    result.missing = missing;
    result.flown.mission.cell_size_m = book_.cellSize_m();
    const ContinuedRun before = record.continues.value_or(ContinuedRun{});
    result.scan = {record,
                   {},
                   {.recording = QFileInfo(path_).absoluteFilePath(),
                    .duration = before.duration + record.status.elapsed,
                    .distance_m = before.distance_m + record.status.distance_flown_m,
                    .charges = before.charges + record.status.charges,
                    .cells = book_.mapper().map().knownCellCount()}};
    if (with_scans_)
        result.scan.record.scans = book_.placedScans();
    for (const auto& tile : book_.mapper().map().takeChangedTiles())
        result.scan.tiles[tile->index] = tile;
    result.rest_in_map =
        remainingArea(record.area_in_map, result.scan.tiles, book_.cellSize_m(), usualGap_m2(record.area_in_map));
    return result;
}

Result<RecordedScan> playRecording(const QString& path, int chain, bool with_scans) {
    if (chain > longest_chain)
        return failure("too many recordings continue one another", path.toStdString(),
                       "Fly the mission again as a whole");
    auto recording = link::RecordingReader::open(path);
    if (!recording)
        return tl::unexpected(recording.error());
    return ScanPlayer(*std::move(recording), chain, with_scans).playMission();
}

} // namespace

double cellSizeOf(const link::RecordingSurvey& survey) {
    const auto fact = survey.facts.find("cell_size_m");
    const auto size_m = fact == survey.facts.end() ? std::nullopt : readNumber(fact->second);
    return size_m && *size_m > 0.0 ? *size_m : Mission{}.cell_size_m;
}

Result<RecordedScan> readRecordedScan(const QString& path, bool with_scans) {
    return playRecording(path, 0, with_scans);
}

Result<RecordedMap> readRecordedMap(const QString& path, bool with_scans) {
    auto recording = link::RecordingReader::open(path);
    if (!recording)
        return tl::unexpected(recording.error());
    return ScanPlayer(*std::move(recording), 0, with_scans).playMap();
}

bool brokeOffInMission(const QString& path) {
    const auto recording = link::RecordingReader::open(path);
    bool in_mission = false;
    while (const auto record = recording ? (*recording)->next() : std::nullopt) {
        if (record->kind != link::RecordKind::Note)
            continue;
        if (record->name == "mission")
            in_mission = true;
        else if (record->name == "finished" || record->name == "behavior")
            in_mission = in_mission && record->name == "behavior";
        else if (record->name == "published" && record->bytes.starts_with("finished"))
            in_mission = false;
    }
    return in_mission;
}

Mission missionOfRest(const RecordedScan& recorded) {
    Mission mission = recorded.flown.mission;
    mission.area_in_map = recorded.rest_in_map;
    return mission;
}

} // namespace usar::mission
