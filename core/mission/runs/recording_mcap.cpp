#include "core/mission/runs/recording_mcap.h"

#include <limits>
#include <memory>
#include <utility>

#include <QEventLoop>
#include <QFileDevice>
#include <QFileInfo>
#include <QSaveFile>

#include "core/base/text.h"
#include "core/link/replay.h"
#include "core/mission/runs/recorded_scan.h"
#include "core/mission/runs/recording_topics.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/reader.h"

namespace usar::mission {

namespace {

/// Lines between two reports of the progress.
constexpr std::uint64_t lines_a_report = 2000;

/// What must be known before the first message.
struct Beginning {
    std::string robot_name;
    Seconds clock{0.0};
    double cell_size_m = 0.0;
};

tl::unexpected<Error> cancellationOf(const std::string& recording) {
    return failure("the export was cancelled, and nothing of it is kept", recording, "Export again whenever you like");
}

std::string robotOf(const link::Record& record) {
    const bool is_spawn =
        record.bytes.starts_with("INIT") &&
        (record.kind == link::RecordKind::Out || (record.kind == link::RecordKind::Note && record.name == "robot"));
    if (!is_spawn)
        return {};
    Diagnostics ignored;
    const protocol::Command command = protocol::readCommand(trimmed(record.bytes), ignored);
    const auto* const init = std::get_if<protocol::Init>(&command);
    return init ? init->robot_name.text() : std::string();
}

/// Reads as far as it must, unless `stop` is requested, and leaves the recording at its beginning.
Beginning beginningOf(link::RecordingReader& recording, const std::stop_token& stop) {
    Beginning beginning;
    const auto& facts = recording.survey().facts;
    if (const auto robot = facts.find("robot"); robot != facts.end())
        beginning.robot_name = robot->second;
    beginning.cell_size_m = cellSizeOf(recording.survey());
    link::PlayClock clock;
    bool has_clock = false;
    const auto misses_something = [&] { return !has_clock || beginning.robot_name.empty(); };
    while (!stop.stop_requested() && misses_something()) {
        const auto record = recording.next();
        if (!record)
            break;
        clock.at(*record);
        if (!has_clock && clock.now())
            beginning.clock = *clock.now();
        has_clock = has_clock || clock.now().has_value();
        if (beginning.robot_name.empty())
            beginning.robot_name = robotOf(*record);
    }
    recording.seek(link::RecordTime{0});
    return beginning;
}

std::string nameOf(const QIODevice& output) {
    const auto* const file = qobject_cast<const QFileDevice*>(&output);
    return file && !file->fileName().isEmpty() ? file->fileName().toStdString() : "the output";
}

/// Plays one recording into one file.
class McapPlayer : private link::ReplayTaker {
public:
    McapPlayer(std::unique_ptr<link::RecordingReader> recording, QIODevice& output, std::stop_token stop,
               McapProgress progress)
        : output_(output)
        , stop_(std::move(stop))
        , progress_(std::move(progress))
        , path_(recording->path())
        , topics_(makeTopics(file_, beginningOf(*recording, stop_)))
        , replayer_(std::move(recording), *this) {}

    Result<McapSummary> play();

private:
    static RecordingTopics makeTopics(McapWriter& file, const Beginning& beginning) {
        return {file, beginning.robot_name, beginning.cell_size_m, beginning.clock};
    }

    void rewound() override {}
    void opened(std::string_view place) override;
    void closed(std::string_view reason) override;
    void line(std::string_view text, LineNumber number) override;
    void sent(const link::Record& record) override;
    void note(const link::Record& record) override;
    void quiet(bool) override {}
    /// Ends the play, and is false from then on, if it was cancelled or the file takes no more.
    bool goesOn();

    std::string complaint() const;

    QIODevice& output_;
    std::stop_token stop_;
    McapProgress progress_;
    std::string path_;
    QEventLoop loop_; ///< before the replayer, whose timer needs the event loop of this thread
    McapWriter file_{[this](const char* bytes, std::size_t count) {
        return output_.write(bytes, static_cast<qint64>(count)) == static_cast<qint64>(count);
    }};
    RecordingTopics topics_;
    protocol::Reader reader_;
    std::uint64_t lines_ = 0;
    bool over_ = false; ///< nothing more is to be written
    link::Replayer replayer_;
};

bool McapPlayer::goesOn() {
    if (over_)
        return false;
    over_ = stop_.stop_requested() || !file_.good();
    if (over_) {
        replayer_.setPlaying(false);
        QMetaObject::invokeMethod(&loop_, &QEventLoop::quit, Qt::QueuedConnection);
    }
    return !over_;
}

void McapPlayer::opened(std::string_view place) {
    if (goesOn())
        topics_.beginConnection(place);
}

void McapPlayer::closed(std::string_view reason) {
    if (goesOn())
        topics_.endConnection(reason);
}

void McapPlayer::sent(const link::Record& record) {
    if (goesOn())
        topics_.takeSent(record);
}

void McapPlayer::note(const link::Record& record) {
    if (goesOn())
        topics_.takeNote(record);
}

void McapPlayer::line(std::string_view text, LineNumber number) {
    if (!goesOn())
        return;
    reader_.continueAfter({number.value - 1});
    topics_.take(reader_.read(text));
    if (progress_ && ++lines_ % lines_a_report == 0)
        progress_(replayer_.figures().position, replayer_.figures().span);
}

Result<McapSummary> McapPlayer::play() {
    QObject::connect(&replayer_, &link::Replayer::ended, &loop_, &QEventLoop::quit, Qt::QueuedConnection);
    replayer_.setSpeed(std::numeric_limits<double>::infinity());
    replayer_.setPlaying(true);
    loop_.exec();
    if (stop_.stop_requested())
        return cancellationOf(path_);
    topics_.finish(replayer_.survey().complaint());
    file_.finish();
    if (!file_.good())
        return failure("cannot write: " + output_.errorString().toStdString(), nameOf(output_),
                       "Make room, or give the output another place");
    const bool damaged = !replayer_.survey().defects().empty() || topics_.leftOut() > 0;
    return McapSummary{file_.messageCount(), file_.channelCount(), complaint(), damaged};
}

std::string McapPlayer::complaint() const {
    std::string text = replayer_.survey().complaint();
    if (topics_.leftOut() > 0)
        text += (text.empty() ? "" : " ") + std::to_string(topics_.leftOut()) +
                " messages were left out, because their values are no numbers or there are too many topics.";
    return text;
}

} // namespace

Result<McapSummary> recordingToMcap(const QString& recording, QIODevice& output, const std::stop_token& stop,
                                    const McapProgress& progress) {
    if (stop.stop_requested())
        return cancellationOf(recording.toStdString());
    auto reader = link::RecordingReader::open(recording);
    if (!reader)
        return tl::unexpected(reader.error());
    return McapPlayer(*std::move(reader), output, stop, progress).play();
}

Result<McapSummary> recordingToMcapFile(const QString& recording, const QString& file, bool replaces,
                                        const std::stop_token& stop, const McapProgress& progress) {
    if (!replaces && QFileInfo::exists(file))
        return failure("there is a file of this name already, and it is left alone", file.toStdString(),
                       "Give the output another name");
    if (stop.stop_requested())
        return cancellationOf(recording.toStdString());
    const QString target = QFileInfo(file).canonicalFilePath(); // Empty if there is no such file yet.
    if (!target.isEmpty() && target == QFileInfo(recording).canonicalFilePath())
        return failure("the output is the recording itself, and it is left alone", file.toStdString(),
                       "Give the output another name");
    QSaveFile output(file);
    if (!output.open(QIODevice::WriteOnly))
        return failure("cannot write: " + output.errorString().toStdString(), file.toStdString(),
                       "Give the output another place");
    auto summary = recordingToMcap(recording, output, stop, progress);
    if (summary && !output.commit())
        return failure("cannot write: " + output.errorString().toStdString(), file.toStdString(),
                       "Make room, or give the output another place");
    return summary;
}

} // namespace usar::mission
