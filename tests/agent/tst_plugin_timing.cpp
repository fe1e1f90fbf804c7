// How long a plugin that hangs may hold its loader up, in wall-clock time.
#include <memory>

#include <QByteArray>
#include <QElapsedTimer>
#include <QFile>
#include <QString>
#include <QTemporaryDir>
#include <QTest>

#include "core/agent/plugins/plugin_loader.h"
#include "tests/suite/suite.h"

namespace tst_plugin_timing {

using namespace usar::agent;

namespace {

const QString slow_file = QStringLiteral(USAR_BINARY_DIR "/tests/plugins/dangerous/slow_to_tell.so");
const QString host_program = QStringLiteral(USAR_BINARY_DIR "/bin/usar-behavior-host");

} // namespace

class tst_PluginTiming : public QObject {
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void nobodyWaitsForItsAnswer();
    void nobodyWaitsForItsEnd();

private:
    void askSlowOne();

    std::unique_ptr<QTemporaryDir> folder_;
    std::unique_ptr<PluginLoader> loader_;
};

void tst_PluginTiming::init() {
    folder_ = std::make_unique<QTemporaryDir>();
    qputenv("USAR_TEST_SLOW_S", "60");
    qputenv("USAR_TEST_SLOW_BEGUN", folder_->filePath("begun").toLocal8Bit());
    loader_ = std::make_unique<PluginLoader>();
    loader_->setPolicy({.host_program = host_program, .isolated = {"Slow robot"}});
}

void tst_PluginTiming::cleanup() {
    loader_.reset();
    qunsetenv("USAR_TEST_SLOW_S");
    qunsetenv("USAR_TEST_SLOW_BEGUN");
}

void tst_PluginTiming::askSlowOne() {
    loader_->scan({slow_file});
    QCOMPARE(loader_->records().front().state, PluginState::Asked);
}

void tst_PluginTiming::nobodyWaitsForItsAnswer() {
    QElapsedTimer clock;
    clock.start();
    askSlowOne();
    QVERIFY2(clock.elapsed() < 1000, qPrintable(QString::number(clock.elapsed())));
}

void tst_PluginTiming::nobodyWaitsForItsEnd() {
    askSlowOne();
    QTRY_VERIFY(QFile::exists(folder_->filePath("begun")));
    QElapsedTimer clock;
    clock.start();
    loader_.reset();
    QVERIFY2(clock.elapsed() < 100, qPrintable(QString::number(clock.elapsed())));
}

USAR_TEST(tst_PluginTiming)

} // namespace tst_plugin_timing

#include "tst_plugin_timing.moc"
