#include <QTest>

#include "core/mission/files/settings_sheet.h"
#include "tests/suite/suite.h"

namespace tst_settings_sheet {

using namespace usar;

class tst_SettingsSheet : public QObject {
    Q_OBJECT
private slots:
    void onlyWhatHasChangedIsWritten() {
        mission::SettingsSheet written, now;
        written.setValue("theme", "dark");
        written.setValue("record", true);
        now = written;
        QVERIFY(now.changedSince(written).isEmpty());
        now.setValue("theme", "light");
        now.setValue("server/port", 3000);
        QCOMPARE(now.changedSince(written), QVariantMap({{"theme", "light"}, {"server/port", 3000}}));
        QCOMPARE(now.changedSince({}).size(), 3);
    }
};

USAR_TEST(tst_SettingsSheet)

} // namespace tst_settings_sheet

#include "tst_settings_sheet.moc"
