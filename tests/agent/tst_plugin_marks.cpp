// Marks of plugins that end the program: whose they are, for which version of the file, and when they do not count.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <unistd.h>

#include "core/agent/plugins/plugin_marks.h"
#include "tests/suite/suite.h"

namespace tst_plugin_marks {

using namespace usar::agent;

namespace {

const QString plugin = QStringLiteral("/robots/rover.so");
constexpr FileStamp stamp{.bytes = 4711, .written_ms = 1'600'000'000'123};

void writeFile(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), qint64(bytes.size()));
}

} // namespace

class tst_PluginMarks : public QObject {
    Q_OBJECT
private slots:
    void aMarkThatStaysNamesItsPlugin() {
        const QTemporaryDir folder;
        const PluginMarks marks(folder.filePath("deep/marks"));
        QVERIFY(!marks.endedTheProgram(plugin, stamp));
        marks.begin(plugin, stamp);
        QVERIFY(marks.endedTheProgram(plugin, stamp));
        QVERIFY(PluginMarks(folder.filePath("deep/marks")).endedTheProgram(plugin, stamp)); // the next start
        marks.end(plugin);
        QVERIFY(!marks.endedTheProgram(plugin, stamp));
    }

    void onlyThatVersionOfThatFileIsMarked_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<qint64>("bytes");
        QTest::addColumn<qint64>("written_ms");
        QTest::addColumn<bool>("marked");
        QTest::newRow("the same") << plugin << stamp.bytes << stamp.written_ms << true;
        QTest::newRow("another size") << plugin << stamp.bytes + 1 << stamp.written_ms << false;
        QTest::newRow("written later") << plugin << stamp.bytes << stamp.written_ms + 1 << false;
        QTest::newRow("written before") << plugin << stamp.bytes << stamp.written_ms - 1 << false;
        QTest::newRow("another file") << QString("/robots/rover2.so") << stamp.bytes << stamp.written_ms << false;
        QTest::newRow("another folder") << QString("/other/rover.so") << stamp.bytes << stamp.written_ms << false;
    }
    void onlyThatVersionOfThatFileIsMarked() {
        QFETCH(QString, file);
        QFETCH(qint64, bytes);
        QFETCH(qint64, written_ms);
        QFETCH(bool, marked);
        const QTemporaryDir folder;
        const PluginMarks marks(folder.path());
        marks.begin(plugin, stamp);
        QCOMPARE(marks.endedTheProgram(file, {bytes, written_ms}), marked);
    }

    void aMarkCountsOnceItsProcessHasEnded_data() {
        QTest::addColumn<QByteArray>("mark");
        QTest::addColumn<bool>("counts");
        const QByteArray first = "4711 1600000000123\n";
        const QByteArray file = plugin.toUtf8() + '\n';
        QTest::newRow("this process") << first + QByteArray::number(::getpid()) + '\n' + file << true;
        QTest::newRow("another that runs") << first + QByteArray::number(::getppid()) + '\n' + file << false;
        QTest::newRow("no process") << first + "0\n" + file << true;
        QTest::newRow("a process that is no number") << first + "who\n" + file << true;
        QTest::newRow("another file of the same hash") << first + "0\n/robots/other.so\n" << false;
        QTest::newRow("cut off before the file") << first + "0" << false;
        QTest::newRow("empty") << QByteArray() << false;
        QTest::newRow("garbage") << QByteArray(200, '\xff') << false;
    }
    void aMarkCountsOnceItsProcessHasEnded() {
        QFETCH(QByteArray, mark);
        QFETCH(bool, counts);
        const QTemporaryDir folder;
        const PluginMarks marks(folder.path());
        marks.begin(plugin, stamp);
        const QStringList names = QDir(folder.path()).entryList(QDir::Files);
        QCOMPARE(names.size(), 1);
        writeFile(folder.filePath(names.first()), mark);
        QCOMPARE(marks.endedTheProgram(plugin, stamp), counts);
    }

    void pluginsHaveMarksOfTheirOwn() {
        const QTemporaryDir folder;
        const PluginMarks marks(folder.path());
        marks.begin("/robots/a.so", stamp);
        marks.begin("/robots/b.so", stamp);
        marks.end("/robots/a.so");
        QVERIFY(!marks.endedTheProgram("/robots/a.so", stamp));
        QVERIFY(marks.endedTheProgram("/robots/b.so", stamp));
    }

    void withoutAFolderNothingIsRemembered_data() {
        QTest::addColumn<PluginMarks>("marks");
        QTest::newRow("none is given") << PluginMarks();
        QTest::newRow("it cannot be made") << PluginMarks("/proc/no/such/folder");
    }
    void withoutAFolderNothingIsRemembered() {
        QFETCH(PluginMarks, marks);
        marks.begin(plugin, stamp);
        QVERIFY(!marks.endedTheProgram(plugin, stamp));
        marks.end(plugin);
    }

    void aStampChangesWithItsFile() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("rover.so");
        writeFile(path, "12345");
        const FileStamp before = stampOf(path);
        QCOMPARE(before.bytes, qint64(5));
        QVERIFY(stampOf(path) == before);
        writeFile(path, "123456");
        QVERIFY(stampOf(path) != before);
        QCOMPARE(stampOf(folder.filePath("none.so")).bytes, qint64(0));
    }
};

USAR_TEST(tst_PluginMarks)

} // namespace tst_plugin_marks

#include "tst_plugin_marks.moc"
