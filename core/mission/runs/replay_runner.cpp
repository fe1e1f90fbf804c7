#include "core/mission/runs/replay_runner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QJsonArray>

#include "core/mission/runs/mission_runner.h"

namespace usar::mission {

namespace {

double rounded(Seconds span) {
    return std::round(span.count() * 1e6) / 1e6;
}

QJsonObject toJson(const std::map<std::string, qint64>& counts) {
    QJsonObject json;
    for (const auto& [name, count] : counts)
        json[QString::fromStdString(name)] = count;
    return json;
}

QJsonObject toJson(const std::map<std::string, std::string>& facts) {
    QJsonObject json;
    for (const auto& [name, value] : facts)
        json[QString::fromStdString(name)] = QString::fromStdString(value);
    return json;
}

} // namespace

ReplayRunner::ReplayRunner(std::unique_ptr<link::RecordingReader> recording, ReplayOptions options)
    : path_(recording->path())
    , options_(std::move(options))
    , replayer_(std::move(recording), *this) {
    connect(&replayer_, &link::Replayer::ended, this, [this] { conclude(false); });
}

void ReplayRunner::start() {
    if (options_.to)
        replayer_.setEnd(*options_.to);
    if (options_.from > Seconds{0.0})
        replayer_.seek(options_.from);
    replayer_.setSpeed(options_.speed);
    replayer_.setPlaying(true);
}

void ReplayRunner::conclude(bool interrupted) {
    if (std::exchange(over_, true))
        return;
    interrupted_ = interrupted;
    replayer_.setPlaying(false);
    const int exit_code = interrupted || isDamaged() ? MissionFailed : Done;
    QMetaObject::invokeMethod(
        this, [this, exit_code] { emit finished(exit_code); }, Qt::QueuedConnection);
}

bool ReplayRunner::isDamaged() const {
    const link::RecordingSurvey& survey = replayer_.survey();
    return !survey.damage.empty() || !survey.not_read.empty();
}

void ReplayRunner::line(std::string_view text, LineNumber number) {
    if (quiet_)
        return;
    reader_.continueAfter({number.value - 1});
    diagnostics_ += static_cast<qint64>(reader_.read(text).diagnostics.size());
    Diagnostics told_already;
    segments_.read(text, told_already);
    std::string type(segments_.typeWord().substr(0, 32));
    if (const std::string_view of = segments_.value("Type"); !of.empty())
        (type += ' ') += of.substr(0, 32);
    ++types_[types_.size() < 1000 ? type : std::string("others")]; // Bounded, because type names come from the wire.
    if (lines_in_++ == 0)
        first_line_ = number;
    last_line_ = number;
    bytes_in_ += static_cast<qint64>(text.size()) + 2;
}

void ReplayRunner::sent(const link::Record& record) {
    if (quiet_)
        return;
    ++lines_out_;
    bytes_out_ += static_cast<qint64>(record.bytes.size());
    ++sources_[sources_.size() < 1000 ? std::string(record.name) : std::string("others")];
}

QJsonObject ReplayRunner::summary() const {
    const link::RecordingSurvey& survey = replayer_.survey();
    QJsonArray damage;
    for (const link::RecordingDamage& piece : survey.damage) {
        const link::RecordingPlace place = survey.placeOf(piece.offset);
        damage.append(QJsonObject{{"file", QString::fromStdString(place.file)},
                                  {"offset", static_cast<qint64>(place.offset)},
                                  {"bytes", static_cast<qint64>(piece.bytes)}});
    }
    const std::string reason = interrupted_ ? "Interrupted." : survey.complaint();
    return {{"success", !interrupted_ && !isDamaged()},
            {"reason", QString::fromStdString(reason)},
            {"file", QString::fromStdString(path_)},
            {"facts", toJson(survey.facts)},
            {"span_s", rounded(survey.play_span)},
            {"arrival_span_s", rounded(survey.span)},
            {"from_s", rounded(options_.from)},
            {"to_s", rounded(std::min<Seconds>(options_.to.value_or(survey.play_span), replayer_.figures().position))},
            {"connections", connections_},
            {"lines_in", lines_in_},
            {"lines_out", lines_out_},
            {"bytes_in", bytes_in_},
            {"bytes_out", bytes_out_},
            {"first_line", static_cast<qint64>(first_line_.value)},
            {"last_line", static_cast<qint64>(last_line_.value)},
            {"types", toJson(types_)},
            {"sources", toJson(sources_)},
            {"published", published_},
            {"diagnostics", diagnostics_},
            {"records", static_cast<qint64>(survey.records)},
            {"file_bytes", static_cast<qint64>(survey.file_bytes)},
            {"ended_in_order", survey.ended},
            {"being_written", survey.being_written},
            {"tail_lost_bytes", static_cast<qint64>(survey.tail_lost_bytes)},
            {"damage", damage}};
}

QJsonObject refusedReplay(const QString& file, const std::string& reason) {
    return {{"success", false}, {"reason", QString::fromStdString(reason)}, {"file", file}};
}

} // namespace usar::mission
