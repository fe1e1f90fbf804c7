// What robots/sample/README.md tells a person to do, done: install, copy, build, fly.
#include <QDir>
#include <QElapsedTimer>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "tests/suite/suite.h"

namespace tst_sample_robot {

namespace {

const QString build = USAR_BINARY_DIR;
const QString source = USAR_SOURCE_DIR;

struct Outcome {
    int exit_code = -1;
    QByteArray output;
    QByteArray said;
};

Outcome run(const QString& program, const QStringList& arguments, const QString& folder = {}) {
    QProcess process;
    process.setWorkingDirectory(folder.isEmpty() ? QDir::currentPath() : folder);
    process.start(program, arguments);
    if (!process.waitForFinished(500'000))
        return {};
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1, process.readAllStandardOutput(),
            process.readAllStandardError()};
}

void copyFolder(const QString& from, const QString& to) {
    QVERIFY(QDir().mkpath(to));
    for (const QString& name : QDir(from).entryList(QDir::Files))
        QVERIFY(QFile::copy(from + '/' + name, to + '/' + name));
}

/// The first block of commands under this heading of a page.
QString commandsUnder(const QString& heading, const QString& page) {
    QFile file(page);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QString text = QString::fromUtf8(file.readAll());
    return text.mid(text.indexOf(heading)).section("```\n", 1, 1);
}

QJsonObject summaryIn(const QByteArray& output) {
    return QJsonDocument::fromJson(output.trimmed().split('\n').last()).object();
}

void buildAndFly(const QString& prefix, const QString& copy, const QString& behavior_id) {
    Outcome made = run("cmake", {"-G", "Ninja", "-B", "build", "-DCMAKE_PREFIX_PATH=" + prefix}, copy);
    QVERIFY2(made.exit_code == 0, made.output + made.said);
    made = run("cmake", {"--build", "build"}, copy);
    QVERIFY2(made.exit_code == 0, made.output + made.said);
    for (const QStringList& how : {QStringList(), QStringList("--isolate")}) {
        const Outcome flown =
            run(prefix + "/bin/usar-mission",
                QStringList{"run", "hop.json", "--plugins", "build/robots", "--out", "results"} + how, copy);
        QVERIFY2(flown.exit_code == 0, flown.output + flown.said);
        QVERIFY(summaryIn(flown.output)["success"].toBool());
        QCOMPARE(summaryIn(flown.output)["behavior"].toString(), behavior_id);
    }
}

} // namespace

class tst_SampleRobot : public QObject {
    Q_OBJECT
private slots:
    void fliesInOurOwnTree();
    void fliesWhereAPersonHasCopiedIt();
};

void tst_SampleRobot::fliesInOurOwnTree() {
    QTemporaryDir results;
    const Outcome flown = run(build + "/bin/usar-mission", {"run", source + "/robots/sample/hop.json", "--plugins",
                                                            build + "/sample", "--out", results.path()});
    QVERIFY2(flown.exit_code == 0, flown.output + flown.said);
    const QJsonObject summary = summaryIn(flown.output);
    QVERIFY(summary["success"].toBool());
    QCOMPARE(summary["behavior"].toString(), QString("sample/hop"));
    QCOMPARE(summary["collisions"].toInt(-1), 0);
    QVERIFY2(std::abs(summary["distance_m"].toDouble() - 5.0) < 1.0, flown.output);
}

void tst_SampleRobot::fliesWhereAPersonHasCopiedIt() {
    QTemporaryDir folder;
    const QString installed_first = folder.filePath("first");
    const QString prefix = folder.filePath("moved/usar"); // it can be moved as a whole
    const QString copy = folder.filePath("my_robot");
    for (const char* component : {"sdk", "headless"}) {
        const Outcome installed =
            run("cmake", {"--install", build, "--prefix", installed_first, "--component", component});
        QVERIFY2(installed.exit_code == 0, installed.output + installed.said);
    }
    QVERIFY(QDir().mkpath(folder.filePath("moved")));
    QVERIFY(QDir().rename(installed_first, prefix));

    copyFolder(prefix + "/share/usar-mission-control/sample", copy);
    buildAndFly(prefix, copy, "sample/hop");
    const QString renaming = commandsUnder("## 5. Your own name", copy + "/README.md");
    QVERIFY(renaming.contains("my_robot"));
    const Outcome renamed = run("bash", {"-e", "-c", renaming}, copy);
    QVERIFY2(renamed.exit_code == 0, renamed.output + renamed.said);
    buildAndFly(prefix, copy, "my_robot/hop");
    QCOMPARE(QDir(copy + "/build/robots").entryList(QDir::Files), QStringList("my_robot.so"));
}

USAR_TEST(tst_SampleRobot)

} // namespace tst_sample_robot

#include "tst_sample_robot.moc"
