#include "tests/hands/program.h"

#include <QDir>
#include <QTest>

namespace usar::hands {

Program::Program(const QSize& screen_px, const QStringList& arguments)
    : desktop_(screen_px)
    , results_(folder_.filePath("results")) {
    if (!desktop_.trouble().isEmpty())
        return;
    reader_.emplace(desktop_.accessibility());
    process_.setProcessEnvironment(desktop_.environment());
    process_.setStandardErrorFile(folder_.filePath("stderr.txt"));
    process_.start(USAR_BINARY_DIR "/bin/mission-control",
                   QStringList{"--port", "0", "--wireless-port", "0", "--out", results_} + arguments);
    process_.waitForStarted();
    reader_->find("frame", "Mission Control");
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
    return process_.state() == QProcess::Running ? QString()
                                                 : "Mission Control does not run: " + process_.errorString();
}

bool Program::click(const QString& role, const QString& name) {
    const auto seen = reader_->find(role, name);
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

QString Program::figure(const QString& name) const {
    const auto seen =
        reader_->find([&name](const Seen& one) { return one.name == name && !one.description.isEmpty(); });
    return seen ? seen->description : QString();
}

bool Program::spawnAt(const QString& start_pose, const QString& robot) {
    const auto pose = reader_->find([&](const Seen& seen) { return seen.name == "Start pose " + start_pose; });
    if (!pose)
        return false;
    desktop_.doubleClick(pose->at.center());
    return reader_->find([&](const Seen& seen) { return seen.name == "Robot " + robot; }).has_value();
}

bool Program::fly() {
    const auto map = reader_->find([](const Seen& seen) { return seen.name == "Map"; });
    if (!map)
        return false;
    desktop_.click(map->at.topLeft() + QPoint(map->at.width() / 2, 30)); // Gives the map the keys.
    desktop_.key("a");
    const QPoint middle = map->at.center();
    desktop_.drag(middle - QPoint(40, 30), middle + QPoint(40, 30));
    return press("Start") &&
           QTest::qWaitFor([this] { return figure("flown").section(' ', 0, 0).toDouble() > 0.0; }, 60000);
}

void Program::screenshot(const QString& name) const {
    const QDir folder(USAR_BINARY_DIR "/screenshots");
    folder.mkpath(".");
    desktop_.screenshot().save(folder.filePath("hands_" + name + ".png"));
}

std::optional<int> Program::ended(int within_ms) {
    if (!process_.waitForFinished(within_ms))
        return std::nullopt;
    return process_.exitCode();
}

} // namespace usar::hands
