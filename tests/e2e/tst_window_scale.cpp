// The real window on screens with larger letters: what starts a robot and what stops all of them stays on the screen.
#include <QFile>
#include <QGuiApplication>
#include <QProcess>
#include <QScreen>
#include <QTemporaryDir>
#include <QTest>

#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window_scale {

using namespace usar;

namespace {

/// Set in the process that has the screen; the scale of a program cannot change while it runs.
constexpr char on_the_screen[] = "USAR_TEST_ON_THE_SCREEN";

/// A screen of this size for Qt's platform without one.
bool writeScreen(const QString& path, int width_px, int height_px) {
    QFile file(path);
    return file.open(QIODevice::WriteOnly) &&
           file.write(QString(R"({"screens": [{"name": "one", "x": 0, "y": 0, "width": %1, "height": %2, )"
                              R"("logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1}]})")
                          .arg(width_px)
                          .arg(height_px)
                          .toUtf8()) > 0;
}

/// True if all of it can be seen: nothing that scrolls hides a part of it, and it is on the screen.
bool isWholeOnScreen(const QWidget& widget) {
    const QRect there(widget.mapToGlobal(QPoint(0, 0)), widget.size());
    return widget.isVisible() && widget.visibleRegion().boundingRect() == widget.rect() &&
           widget.screen()->availableGeometry().contains(there);
}

void findBothButtons(double scale, const QSize& screen_px) {
    const QRect screen = QGuiApplication::primaryScreen()->availableGeometry();
    QCOMPARE(QGuiApplication::primaryScreen()->devicePixelRatio(), scale);
    QCOMPARE((QSizeF(screen.size()) * scale).toSize(), screen_px);
    WindowPage page({.first_start = true});
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.window().move(screen.topLeft());
    const QSize frame = page.window().frameGeometry().size() - page.window().size();
    page.window().resize(screen.size() - frame);
    QVERIFY(page.spawnAt("PlayerStart"));
    QTRY_VERIFY(isWholeOnScreen(*page.window().views().stop_all));
    QTRY_VERIFY(isWholeOnScreen(*page.window().views().behavior->startButton()));
}

} // namespace

class tst_WindowScale : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void startAndStopAreOnTheScreen_data() {
        QTest::addColumn<double>("scale");
        QTest::addColumn<QSize>("screen_px");
        QTest::newRow("125") << 1.25 << QSize(1920, 1080);
        QTest::newRow("150") << 1.5 << QSize(1920, 1080);
        QTest::newRow("200") << 2.0 << QSize(3840, 2160);
        QTest::newRow("300") << 3.0 << QSize(3840, 2160);
    }

    void startAndStopAreOnTheScreen() {
        QFETCH(double, scale);
        QFETCH(QSize, screen_px);
        if (qEnvironmentVariableIsSet(on_the_screen))
            return findBothButtons(scale, screen_px);
        QTemporaryDir folder;
        QVERIFY(writeScreen(folder.filePath("screen.json"), screen_px.width(), screen_px.height()));
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(on_the_screen, "1");
        environment.insert("QT_SCALE_FACTOR", QString::number(scale));
        environment.insert("QT_SCALE_FACTOR_ROUNDING_POLICY", "PassThrough");
        environment.insert("QT_QPA_PLATFORM", "offscreen:configfile=" + folder.filePath("screen.json"));
        QProcess program;
        program.setProcessEnvironment(environment);
        program.setProcessChannelMode(QProcess::MergedChannels);
        program.start(QCoreApplication::applicationFilePath(),
                      {"tst_window_scale", QString("startAndStopAreOnTheScreen:%1").arg(QTest::currentDataTag())});
        const bool ended = program.waitForFinished(120'000);
        const QByteArray said = program.readAll();
        QVERIFY2(ended && program.exitStatus() == QProcess::NormalExit && program.exitCode() == 0, said);
        const QByteArray row = QByteArray("startAndStopAreOnTheScreen(") + QTest::currentDataTag() + ")";
        QVERIFY2(said.contains("PASS") && said.contains(row), said);
    }
};

USAR_TEST(tst_WindowScale)

} // namespace tst_window_scale

#include "tst_window_scale.moc"
