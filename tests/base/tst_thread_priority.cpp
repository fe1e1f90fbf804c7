#include <algorithm>
#include <thread>

#include <sys/resource.h>

#include <QTest>

#include "core/base/thread_priority.h"
#include "tests/suite/suite.h"

namespace tst_thread_priority {

using namespace usar;

class tst_ThreadPriority : public QObject {
    Q_OBJECT
private slots:
    /// On Linux, 0 is the calling thread.
    void aThreadYieldsWithThoseThatItStarts() {
        const int usual = getpriority(PRIO_PROCESS, 0);
        int own = usual, of_its_child = usual, of_another = 0;
        std::thread([&] {
            yieldToOthers();
            yieldToOthers(); // A second time changes nothing.
            own = getpriority(PRIO_PROCESS, 0);
            std::thread([&] { of_its_child = getpriority(PRIO_PROCESS, 0); }).join();
        }).join();
        std::thread([&] { of_another = getpriority(PRIO_PROCESS, 0); }).join();
        QCOMPARE(own, std::min(usual + 10, 19));
        QCOMPARE(of_its_child, own);
        QCOMPARE(of_another, usual);
        QCOMPARE(getpriority(PRIO_PROCESS, 0), usual);
    }
};

USAR_TEST(tst_ThreadPriority)

} // namespace tst_thread_priority

#include "tst_thread_priority.moc"
