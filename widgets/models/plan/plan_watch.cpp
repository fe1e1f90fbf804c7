#include "widgets/models/plan/plan_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QObject>
#include <QStringList>

#include "core/posh/run/value_text.h"

namespace usar::widgets {

namespace {

Seconds seconds(std::int64_t time_ms) {
    return Seconds(static_cast<double>(time_ms) / 1000.0);
}

/// Numbers are shortened to six digits, which are easier to read than sixteen.
QString shown(const posh::Value& answer) {
    if (const auto* const number = std::get_if<double>(&answer))
        return QString::fromStdString(posh::toText(posh::Value(QString::number(*number, 'g', 6).toDouble())));
    return QString::fromStdString(posh::toText(answer));
}

PlanActivity shown(const posh::PlaceActivity& place) {
    PlanActivity activity;
    activity.running = place.running;
    if (place.last_active_ms)
        activity.last_active = seconds(*place.last_active_ms);
    activity.started = place.started;
    activity.succeeded = place.succeeded;
    activity.failed = place.failed;
    activity.skipped = place.skipped;
    activity.hold_back = QString::fromStdString(place.hold_back);
    if (place.answer)
        activity.answer = SenseAnswer{shown(place.answer->value), place.answer->holds, seconds(place.answer->since_ms),
                                      seconds(place.answer->asked_ms)};
    return activity;
}

BoardValue shown(const posh::BoardEntry& entry, const posh::Program& program) {
    QStringList lines;
    for (const auto& written : entry.values)
        lines.prepend(QObject::tr("%1 at %2 s, by %3")
                          .arg(QString::fromStdString(written.value),
                               QString::number(seconds(written.time_ms).count(), 'f', 1),
                               written.writer < program.places.size()
                                   ? QString::fromStdString(posh::namePathOf(program, written.writer))
                                   : QString()));
    if (entry.writes > entry.values.size())
        lines << QObject::tr("written %1 times in all").arg(entry.writes);
    return {QString::fromStdString(entry.key), QString::fromStdString(entry.values.back().value), lines.join('\n')};
}

std::shared_ptr<const std::vector<std::string>> pathsOf(const posh::Program& program) {
    auto paths = std::make_shared<std::vector<std::string>>();
    for (posh::Index place = 0; place < program.places.size(); ++place)
        paths->push_back(posh::pathOf(program, place));
    return paths;
}

} // namespace

PlanWatch::News PlanWatch::take(const Update& update) {
    is_replay_ = update.is_replay;
    const bool has_moved = std::exchange(now_, update.now) != now_;
    if (update.rewound) {
        heard_ = 0;
        all_heard_ = history_.bytes().empty();
        moment_.reset();
        epoch_.reset();
    }
    bool heard = update.rewound;
    for (const agent::Published& published : update.published)
        if (const auto* const trace = std::get_if<agent::PlanTrace>(&published); trace && !trace->bytes.empty()) {
            hear(trace->bytes);
            heard = true;
        }
    heard = heard || (has_moved && is_replay_ && !all_heard_);
    if (heard && moment_)
        return News::Activity; // The run has continued, but the shown moment stays the same.
    return heard ? refresh() : News::None;
}

/// Takes the next piece of the trace. A rewound replay repeats bytes that are known already; bytes that differ begin
/// another run or continue this one differently, and replace what was known.
void PlanWatch::hear(const std::string& piece) {
    const std::string_view known = std::string_view(history_.bytes()).substr(heard_, piece.size());
    const bool begins = piece.starts_with(posh::trace_codec::magic);
    if (!known.empty() && known == piece) {
        heard_ += piece.size();
    } else if (begins || history_.bytes().empty()) {
        startWith(expected_.starts_with(piece) ? expected_ : piece);
        heard_ = piece.size();
    } else {
        if (!known.empty())
            startWith(history_.bytes().substr(0, heard_));
        history_.append(piece);
        heard_ += piece.size();
    }
    all_heard_ = heard_ == history_.bytes().size();
}

void PlanWatch::startWith(const std::string& trace) {
    history_.clear();
    moment_.reset();
    epoch_.reset();
    history_.append(trace);
}

/// A robot publishes a cycle when the next one begins. A replay need not wait for that if the trace is known already:
/// its clock tells which cycle is the current one.
std::optional<std::size_t> PlanWatch::heardMoment() const {
    const auto& moments = history_.moments();
    if (is_replay_ && heard_ > 0 && now_.count() > 0.0 && !moments.empty()) {
        const std::int64_t now_ms = std::llround(now_.count() * 1000.0);
        return moments.front().time_ms <= now_ms ? std::optional(history_.momentAt(now_ms)) : std::nullopt;
    }
    const auto after = std::ranges::upper_bound(moments, heard_, {}, &posh::RunMoment::bytes);
    return after == moments.begin() ? std::nullopt
                                    : std::optional(static_cast<std::size_t>(after - moments.begin()) - 1);
}

PlanWatch::News PlanWatch::refresh() {
    if (moment_ || !all_heard_) {
        if (const auto moment = shownMoment())
            shown_ = history_.at(*moment, epoch_);
        else
            shown_.start(nullptr);
    }
    if (activity().program() == program_)
        return empty() ? News::None : News::Activity;
    program_ = activity().program();
    if (!program_) {
        paths_.reset();
        return News::Plan;
    }
    paths_ = pathsOf(*program_);
    text_ = history_.planText(*shownMoment());
    reading_ = posh::readPlan(text_);
    return News::Plan;
}

const std::vector<std::string>& PlanWatch::paths() const {
    static const std::vector<std::string> none;
    return paths_ ? *paths_ : none;
}

PlanTime PlanWatch::time() const {
    PlanTime time{.live = live(), .replay = is_replay_};
    const auto moment = shownMoment();
    if (!moment)
        return time;
    const auto& moments = history_.moments();
    time.begin = seconds(moments.front().time_ms);
    time.end = seconds(moments.back().time_ms);
    time.shown = seconds(moments[*moment].time_ms);
    time.cycle = moments[*moment].cycle;
    if (epoch_) {
        time.epoch = *epoch_ + 1;
        time.epochs = history_.epochCount(*moment);
    }
    return time;
}

PlanWatch::News PlanWatch::goToMoment(std::optional<std::size_t> moment, std::optional<std::size_t> epoch) {
    if (history_.moments().empty())
        return News::None;
    moment_ = moment;
    epoch_ = epoch;
    return refresh();
}

PlanWatch::News PlanWatch::goTo(Seconds time) {
    if (history_.moments().empty())
        return News::None;
    return goToMoment(history_.momentAt(std::llround(time.count() * 1000.0)), std::nullopt);
}

PlanWatch::News PlanWatch::step(int cycles) {
    const auto shown = shownMoment();
    if (!shown)
        return News::None;
    const auto wanted = static_cast<std::int64_t>(*shown) + cycles;
    if (wanted + 1 >= std::ssize(history_.moments()))
        return goLive();
    return goToMoment(static_cast<std::size_t>(std::max<std::int64_t>(0, wanted)), std::nullopt);
}

PlanWatch::News PlanWatch::stepEpoch() {
    if (!moment_ || !epoch_ || *epoch_ + 1 >= history_.epochCount(*moment_))
        return News::None;
    return goToMoment(moment_, *epoch_ + 1);
}

PlanWatch::News PlanWatch::goToFirstEpoch() {
    const auto newest = heardMoment();
    if (!newest || history_.epochCount(*newest) < 2)
        return News::None;
    return goToMoment(newest, 0);
}

Seconds PlanWatch::timeOfStep(int cycles) const {
    const auto shown = shownMoment();
    if (!shown)
        return Seconds{0.0};
    const auto last = std::ssize(history_.moments()) - 1;
    const auto wanted = std::clamp<std::int64_t>(static_cast<std::int64_t>(*shown) + cycles, 0, last);
    return seconds(history_.moments()[static_cast<std::size_t>(wanted)].time_ms);
}

PlanSnapshot PlanWatch::snapshot() const {
    PlanSnapshot snapshot{.paths = paths_, .activities = {}, .now = seconds(activity().now_ms())};
    for (const posh::PlaceActivity& place : activity().places())
        snapshot.activities.push_back(shown(place));
    for (const posh::BoardEntry& entry : activity().board())
        snapshot.board.push_back(shown(entry, *program()));
    return snapshot;
}

} // namespace usar::widgets
