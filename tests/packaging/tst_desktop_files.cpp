// What the component `window` installs for a desktop: its entry, its page in a software center, file types and icons.
#include <QDir>
#include <QFile>
#include <QImage>
#include <QMimeDatabase>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "core/link/recording_writer.h"
#include "core/sim/snapshot.h"
#include "tests/suite/suite.h"

namespace tst_desktop_files {

using namespace usar;

namespace {

const QString source = USAR_SOURCE_DIR;

struct Outcome {
    int exit_code = -1;
    QString said; ///< to both outputs
};

Outcome run(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments);
    if (!process.waitForFinished(120'000) || process.exitStatus() != QProcess::NormalExit)
        return {-1, process.errorString()};
    return {process.exitCode(), QString::fromUtf8(process.readAll())};
}

QByteArray readAll(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void writeAll(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY2(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size(), qPrintable(path));
}

/// All that the expression captures, in the order of the alphabet.
QStringList allOf(const char* expression, const QByteArray& text) {
    QStringList found;
    auto matches = QRegularExpression(expression).globalMatch(QString::fromUtf8(text));
    while (matches.hasNext())
        found << matches.next().captured(1);
    found.sort();
    return found;
}

} // namespace

class tst_DesktopFiles : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void theEntryIsInOrder();
    void theSoftwareCenterTakesThePage_data();
    void theSoftwareCenterTakesThePage();
    void allNameTheSameTypes();
    void everyFileHasItsType_data();
    void everyFileHasItsType();
    void everyTypeHasAnIcon();

private:
    QString installed(const QString& path) const { return prefix_.path() + "/share/" + path; }

    QTemporaryDir prefix_;
    QTemporaryDir samples_;
    QStringList types_; ///< that the program installs
};

void tst_DesktopFiles::initTestCase() {
    const Outcome install =
        run("cmake", {"--install", USAR_BINARY_DIR, "--prefix", prefix_.path(), "--component", "window"});
    QVERIFY2(install.exit_code == 0, qPrintable(install.said));
    const Outcome update = run("update-mime-database", {"-V", installed("mime")});
    QVERIFY2(update.exit_code == 0 && !update.said.contains("rror"), qPrintable(update.said));
    types_ = allOf("<mime-type type=\"([^\"]+)\"", readAll(installed("mime/packages/usar-mission-control.xml")));
    QCOMPARE(types_.size(), 5);
    // Before the first question to QMimeDatabase, which reads the folders once.
    qputenv("XDG_DATA_DIRS", (prefix_.path() + "/share:/usr/share").toUtf8());
    qputenv("XDG_DATA_HOME", samples_.path().toUtf8());

    { // The file is whole once its writer is gone.
        const auto made =
            link::RecordingWriter::create(samples_.filePath("flight.usarrec"), {{"program", "a test"}}, {});
        QVERIFY2(made, made ? "" : made.error().text().c_str());
    }
    writeAll(samples_.filePath("run.usarsnap"), QByteArray::fromStdString(sim::write(sim::Snapshot{})));
    const QByteArray mission = readAll(source + "/resources/missions/quick_scan.json");
    writeAll(samples_.filePath("quick_scan.mission.json"), mission);
    writeAll(samples_.filePath("settings.json"), mission);
    const QByteArray world = readAll(USAR_BINARY_DIR "/share/worlds/vmac_room/world.sdf");
    writeAll(samples_.filePath("world.sdf"), world);
    writeAll(samples_.filePath("robot.sdf"), world);
    const QByteArray plan = readAll(source + "/resources/plans/airrobot.lap");
    writeAll(samples_.filePath("airrobot.lap"), plan);
    writeAll(samples_.filePath("airrobot.posh"), plan);
    writeAll(samples_.filePath("airrobot.txt"), plan);
    QVERIFY(!mission.isEmpty() && !world.isEmpty() && !plan.isEmpty());
    for (const auto& [with, without] : {std::pair("flight.usarrec", "flight"), {"run.usarsnap", "run"}})
        writeAll(samples_.filePath(without), readAll(samples_.filePath(with)));
}

void tst_DesktopFiles::theEntryIsInOrder() {
    const QString entry = installed("applications/usar-mission-control.desktop");
    const Outcome checked = run("desktop-file-validate", {entry});
    QCOMPARE(checked.said, QString()); // not even a hint
    QCOMPARE(checked.exit_code, 0);
    const QString program = allOf("\nExec=(\\S+) %f\n", readAll(entry)).value(0);
    QVERIFY2(QFileInfo(prefix_.path() + "/bin/" + program).isExecutable(), qPrintable(program));
}

void tst_DesktopFiles::theSoftwareCenterTakesThePage_data() {
    QTest::addColumn<QByteArray>("pictures"); // the address where they are published
    QTest::newRow("as it is installed") << QByteArray();
    QTest::newRow("with pictures") << QByteArray("https://example.org/docs");
}

void tst_DesktopFiles::theSoftwareCenterTakesThePage() {
    QFETCH(QByteArray, pictures);
    QString page = installed("metainfo/usar-mission-control.metainfo.xml");
    if (!pictures.isEmpty()) {
        QByteArray text = readAll(source + "/resources/packaging/usar-mission-control.metainfo.xml.in");
        text.replace("@PROJECT_VERSION@", "0.1.0").replace("@USAR_RELEASE_DATE@", "2026-11-27");
        text.replace("@USAR_PICTURES_URL@", pictures);
        page = samples_.filePath("with_pictures.metainfo.xml");
        writeAll(page, text);
        const QString picture = allOf("/([^/]+\\.png)</image>", text).value(0);
        const QImage image(source + "/resources/docs/" + picture);
        QCOMPARE(allOf("width=\"(\\d+)\"", text), QStringList{QString::number(image.width())});
        QCOMPARE(allOf("height=\"(\\d+)\"", text), QStringList{QString::number(image.height())});
    }
    const Outcome checked = run("appstreamcli", {"validate", "--no-net", "--pedantic", "--no-color", page});
    QVERIFY2(checked.exit_code == 0 && !checked.said.contains(QRegularExpression("^[EWIP]: ")),
             qPrintable(checked.said));
}

void tst_DesktopFiles::allNameTheSameTypes() {
    QStringList entry = allOf("\nMimeType=([^\n]+);\n", readAll(installed("applications/usar-mission-control.desktop")))
                            .value(0)
                            .split(';');
    entry.sort();
    QCOMPARE(entry, types_);
    QCOMPARE(allOf("<mediatype>([^<]+)</mediatype>", readAll(installed("metainfo/usar-mission-control.metainfo.xml"))),
             types_);
}

void tst_DesktopFiles::everyFileHasItsType_data() {
    QTest::addColumn<QString>("type");
    QTest::newRow("flight.usarrec") << "application/x-usar-recording";
    QTest::newRow("flight") << "application/x-usar-recording"; // by its first bytes
    QTest::newRow("run.usarsnap") << "application/x-usar-snapshot";
    QTest::newRow("run") << "application/x-usar-snapshot";
    QTest::newRow("quick_scan.mission.json") << "application/x-usar-mission+json";
    QTest::newRow("settings.json") << "application/json"; // which other programs write, too
    QTest::newRow("world.sdf") << "application/x-usar-world+xml";
    QTest::newRow("robot.sdf") << "application/xml";
    QTest::newRow("airrobot.lap") << "text/x-posh-plan";
    QTest::newRow("airrobot.posh") << "text/x-posh-plan";
    QTest::newRow("airrobot.txt") << "text/plain";
}

void tst_DesktopFiles::everyFileHasItsType() {
    QTEST(QMimeDatabase().mimeTypeForFile(samples_.filePath(QTest::currentDataTag())).name(), "type");
}

void tst_DesktopFiles::everyTypeHasAnIcon() {
    const QString hicolor = installed("icons/hicolor/");
    QStringList icons{"apps/usar-mission-control"};
    for (const QString& type : types_)
        icons << "mimetypes/" + QMimeDatabase().mimeTypeForName(type).iconName();
    for (const QString& icon : icons) {
        const QByteArray drawing = readAll(hicolor + "scalable/" + icon + ".svg");
        QVERIFY2(drawing.startsWith("<svg xmlns"), qPrintable(icon));
        for (const int size : {16, 22, 24, 32, 48, 64, 128, 256, 512}) {
            const QImage image(hicolor + QString("%1x%1/").arg(size) + icon + ".png");
            QCOMPARE(image.size(), QSize(size, size));
            QCOMPARE(qAlpha(image.pixel(0, 0)), 0);
            QVERIFY(qAlpha(image.pixel(size / 2, size / 2)) > 200);
        }
    }
}

USAR_TEST(tst_DesktopFiles)

} // namespace tst_desktop_files

#include "tst_desktop_files.moc"
