#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/mission/files/recent_files.h"
#include "tests/suite/suite.h"

namespace tst_recent_files {

using namespace usar;

class tst_RecentFiles : public QObject {
    Q_OBJECT
private slots:
    void theNewestIsFirstAndEachIsThereOnce();
    void theOldestAreForgotten();
    void whatIsGoneIsLeftOut();
};

void tst_RecentFiles::theNewestIsFirstAndEachIsThereOnce() {
    mission::RecentFiles files;
    files.restore({"/runs/a.json"});
    files.add("/runs/b.lap");
    files.add("/runs/../runs/c.usarrec");
    files.add("/runs/a.json");
    files.add("/runs/c.usarrec");
    QCOMPARE(files.all(), QStringList({"/runs/c.usarrec", "/runs/a.json", "/runs/b.lap"}));
}

void tst_RecentFiles::theOldestAreForgotten() {
    mission::RecentFiles files;
    for (int i = 0; i < 12; ++i)
        files.add(QString("/runs/%1.json").arg(i));
    QCOMPARE(files.all().size(), 10);
    QCOMPARE(files.all().front(), "/runs/11.json");
    QCOMPARE(files.all().back(), "/runs/2.json");
}

void tst_RecentFiles::whatIsGoneIsLeftOut() {
    const QTemporaryDir folder;
    QFile there(folder.filePath("there.json"));
    QVERIFY(there.open(QIODevice::WriteOnly));
    mission::RecentFiles files;
    files.restore({folder.filePath("gone.json"), there.fileName()});
    QCOMPARE(files.existing(), QStringList{there.fileName()});
    QCOMPARE(files.all().size(), 2); // A folder that is not mounted now may be there later.
}

USAR_TEST(tst_RecentFiles)

} // namespace tst_recent_files

#include "tst_recent_files.moc"
