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

/// Reads as far as it must, and leaves the recording at its beginning.
Beginning beginningOf(link::RecordingReader& recording) {
    Beginning beginning;
    const auto& facts = recording.survey().facts;
    if (const auto robot = facts.find("robot"); robot != facts.end())
        beginning.robot_name = robot->second;
    beginning.cell_size_m = cellSizeOf(recording.survey());
    link::PlayClock clock;
    bool has_clock = false;
    while (const auto record = !has_clock || beginning.robot_name.empty() ? recording.next() : std::nullopt) {
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
        , topics_(makeTopics(file_, beginningOf(*recording)))
        , replayer_(std::move(recording), *this) {}

    Result<McapSummary> play();

private:
    static RecordingTopics makeTopics(McapWriter& file, const Beginning& beginning) {
        return {file, beginning.robot_name, beginning.cell_size_m, beginning.clock};
    }

    void rewound() override {}
    void opened(std::string_view place) override { topics_.beginConnection(place); }
    void closed(std::string_view reason) override { topics_.endConnection(reason); }
    void line(std::string_view text, LineNumber number) override;
    void sent(const link::Record& record) override { topics_.takeSent(record); }
    void note(const link::Record& record) override { topics_.takeNote(record); }
    void quiet(bool) override {}

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

void McapPlayer::line(std::string_view text, LineNumber number) {
    if (over_)
        return;
    reader_.continueAfter({number.value - 1});
    topics_.take(reader_.read(text));
    if (progress_ && ++lines_ % lines_a_report == 0)
        progress_(replayer_.figures().position, replayer_.figures().span);
    over_ = stop_.stop_requested() || !file_.good();
    if (over_) {
        replayer_.setPlaying(false);
        QMetaObject::invokeMethod(&loop_, &QEventLoop::quit, Qt::QueuedConnection);
    }
}

Result<McapSummary> McapPlayer::play() {
    QObject::connect(&replayer_, &link::Replayer::ended, &loop_, &QEventLoop::quit, Qt::QueuedConnection);
    replayer_.setSpeed(std::numeric_limits<double>::infinity());
    replayer_.setPlaying(true);
    loop_.exec();
    if (stop_.stop_requested())
        return failure("the export was cancelled, and nothing of it is kept", path_, "Export again whenever you like");
    topics_.finish(replayer_.survey().complaint());
    file_.finish();
    if (!file_.good())
        return failure("cannot write: " + output_.errorString().toStdString(), nameOf(output_),
                       "Make room, or give the output another place");
    return McapSummary{file_.messageCount(), file_.channelCount(), complaint()};
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
