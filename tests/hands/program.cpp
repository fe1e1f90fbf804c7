#include "tests/hands/program.h"

#include <algorithm>

#include <QDir>
#include <QTest>

namespace usar::hands {

namespace {

constexpr int patience_ms = 90000; ///< of a machine that does much else

} // namespace

Program::Program(const QSize& screen_px, const QStringList& arguments)
    : desktop_(screen_px)
    , results_(folder_.filePath("results")) {
    if (!desktop_.trouble().isEmpty())
        return;
    reader_.emplace(desktop_.accessibility(), screen_px);
    process_.setProcessEnvironment(desktop_.environment());
    process_.setStandardErrorFile(folder_.filePath("stderr.txt"));
    endWithUs(process_);
    process_.start(qEnvironmentVariable("USAR_PROGRAM", USAR_BINARY_DIR "/bin/mission-control"),
                   QStringList{"--port", "0", "--wireless-port", "0", "--out", results_} + arguments);
    process_.waitForStarted();
    // A window is on the screen before the window manager gives it the keyboard; keys would be lost until then.
    has_keyboard_ =
        reader_->find([](const Seen& seen) { return seen.role == "frame" && seen.active(); }, patience_ms).has_value();
}

Program::~Program() {
    process_.terminate();
    if (!process_.waitForFinished(15000))
        process_.kill();
    process_.waitForFinished();
}

QString Program::trouble() const {
    if (!desktop_.trouble().isEmpty())
        return desktop_.trouble();
    if (process_.state() != QProcess::Running)
        return "Mission Control does not run: " + process_.errorString();
    return has_keyboard_ ? QString() : QStringLiteral("No window of Mission Control gets the keyboard.");
}

std::optional<Seen> Program::settled(const ScreenReader::Wanted& wanted) const {
    std::optional<Seen> before;
    const bool stands = QTest::qWaitFor(
        [&] {
            const std::optional<Seen> now = reader_->find(wanted, 0);
            const bool same = now && before && now->at == before->at && now->path == before->path;
            before = now;
            return same;
        },
        patience_ms);
    return stands ? before : std::nullopt;
}

bool Program::keyChanges(const QString& key, const std::function<QString()>& look) {
    constexpr int soon_ms = 5000;
    const QString before = look();
    desktop_.key(key);
    return QTest::qWaitFor([&] { return look() != before; }, soon_ms);
}

bool Program::click(const QString& role, const QString& name) {
    const auto seen = settled([&](const Seen& one) {
        return one.role == role && one.enabled() && QString(one.name).remove('&').contains(name, Qt::CaseInsensitive);
    });
    if (seen)
        desktop_.click(seen->at.center());
    return seen.has_value();
}

bool Program::says(const QString& words, int within_ms) const {
    const auto hasWords = [&words](const Seen& seen) {
        return seen.name.contains(words) || seen.description.contains(words);
    };
    return reader_->find(hasWords, within_ms).has_value();
}

bool Program::tabTo(const QString& role) {
    const auto is_there = [&](const Seen& seen) { return seen.role == role && seen.focused(); };
    const auto focus = [this] { // Groups say that they have it, too.
        QStringList paths;
        for (const Seen& seen : reader_->all([](const Seen& one) { return one.focused(); }))
            paths << seen.path;
        return paths.join(' ');
    };
    constexpr int most_widgets = 12;
    for (int i = 0; i < most_widgets; ++i) {
        keyChanges("Tab", focus);
        if (reader_->find(is_there, 0))
            return true;
    }
    return false;
}

QString Program::figure(const QString& name) const {
    const auto seen =
        reader_->find([&name](const Seen& one) { return one.name == name && !one.description.isEmpty(); });
    return seen ? seen->description : QString();
}

QString Program::row(const QString& robot) const {
    const auto seen =
        reader_->find([&](const Seen& one) { return one.role == "list item" && one.name.startsWith(robot + ","); }, 0);
    return seen ? seen->name : QString();
}

bool Program::lookAtWorld() {
    const auto map = settled([](const Seen& seen) { return seen.name == "Map"; });
    if (!map)
        return false;
    desktop_.click(map->at.topLeft() + QPoint(12, map->at.height() / 2));
    desktop_.key("Home");
    return true;
}

bool Program::spawnAt(const QString& start_pose, const QString& robot) {
    const auto pose = settled([&](const Seen& seen) { return seen.name == "Start pose " + start_pose; });
    if (!pose)
        return false;
    desktop_.doubleClick(pose->at.center());
    return QTest::qWaitFor([&] { return !row(robot).isEmpty(); }, patience_ms);
}

bool Program::takesMark(const QString& start_pose) {
    const auto mark = [this] {
        return reader_->find([](const Seen& seen) { return seen.name == "Map"; }, 0).value_or(Seen{}).description;
    };
    constexpr int most_poses = 20;
    for (int i = 0; i < most_poses; ++i) {
        keyChanges("n", mark);
        if (mark().startsWith("Start pose " + start_pose + "."))
            return true;
    }
    return false;
}

bool Program::spawnByKeys(const QString& start_pose, const QString& robot) {
    if (!says("Connected") || !lookAtWorld() || !takesMark(start_pose))
        return false;
    desktop_.key("Return");
    return QTest::qWaitFor([&] { return !row(robot).isEmpty(); }, patience_ms);
}

bool Program::fly() {
    const auto is_there = [this] { // Start does nothing before the robot has spoken.
        const auto list = reader_->all([](const Seen& seen) { return seen.role == "list item"; });
        return !list.empty() &&
               std::ranges::none_of(list, [](const Seen& seen) { return seen.name.contains("spawning"); });
    };
    if (!QTest::qWaitFor(is_there, patience_ms) || !lookAtWorld())
        return false;
    const auto map = settled([](const Seen& seen) { return seen.name == "Map"; });
    if (!map)
        return false;
    desktop_.key("a");
    const QPoint middle = map->at.center();
    desktop_.drag(middle - QPoint(40, 30), middle + QPoint(40, 30));
    return press("Start") && QTest::qWaitFor([this] { return number("flown") > 0.0; }, patience_ms);
}

void Program::screenshot(const QString& name) const {
    const QDir folder(USAR_BINARY_DIR "/screenshots");
    folder.mkpath(".");
    desktop_.screenshot().save(folder.filePath("hands_" + name + ".png"));
}

std::optional<int> Program::ended(int within_ms) {
    // Waiting fails where it has ended already.
    if (process_.state() != QProcess::NotRunning && !process_.waitForFinished(within_ms))
        return std::nullopt;
    return process_.exitCode();
}

} // namespace usar::hands
