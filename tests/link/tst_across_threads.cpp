// Calls and signals from one thread to another. Under ThreadSanitizer it also tries that nothing of it is taken for a
// race.
#include <memory>
#include <string>
#include <vector>

#include <QObject>
#include <QTest>
#include <QThread>

#include "core/link/across_threads.h"
#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"

namespace tst_across_threads {

using namespace usar::link;

class Speaker : public QObject {
    Q_OBJECT
signals:
    void spoke(const std::string& words, int number);
    void fellSilent();
};

class Hearer : public QObject {
    Q_OBJECT
public:
    void hear(const std::string& words, int number) {
        heard.push_back(words + " " + std::to_string(number));
        in_own_thread = in_own_thread && QThread::currentThread() == thread();
    }
    std::vector<std::string> heard;
    bool in_own_thread = true;
signals:
    void passedOn(const std::string& words, int number);
};

/// An object in a thread of its own, which ends before it.
template <class Object>
struct Elsewhere {
    Elsewhere() {
        object->moveToThread(&thread);
        thread.start();
    }
    ~Elsewhere() {
        thread.quit();
        thread.wait();
    }
    QThread thread;
    std::unique_ptr<Object> object = std::make_unique<Object>();
};

class tst_AcrossThreads : public QObject {
    Q_OBJECT
private slots:
    void aPostedCallIsMadeInTheThreadOfItsObject();
    void callsKeepTheirOrder();
    void inTheSameThreadACallIsMadeAtOnce();
    void whoWaitsSeesWhatWasDone();
    void aSignalArrivesWithCopiesOfItsArguments();
    void aSignalCanBePassedOn();
    void whatIsUnderWayIsLostWithItsReceiver();
};

void tst_AcrossThreads::aPostedCallIsMadeInTheThreadOfItsObject() {
    const Elsewhere<QObject> there;
    auto text = std::make_shared<std::string>("written before");
    QThread* made_in = nullptr;
    bool made = false;
    post(there.object.get(), [&, text] {
        QThread* const thread = QThread::currentThread();
        post(this, [&, thread, length = text->size()] {
            made_in = thread;
            made = length == 14;
        });
    });
    text.reset(); // the call has its own
    QTRY_VERIFY(made);
    QVERIFY(made_in == &there.thread);
}

void tst_AcrossThreads::callsKeepTheirOrder() {
    const Elsewhere<Hearer> there;
    for (int i = 0; i < 1000; ++i)
        post(there.object.get(), [hearer = there.object.get(), i] { hearer->hear("call", i); });
    std::vector<std::string> heard;
    auto look = [&] { heard = there.object->heard; };
    postAndWait(there.object.get(), look);
    QCOMPARE(heard.size(), std::size_t(1000));
    QCOMPARE(heard.front(), std::string("call 0"));
    QCOMPARE(heard.back(), std::string("call 999"));
}

void tst_AcrossThreads::inTheSameThreadACallIsMadeAtOnce() {
    bool made = false;
    post(this, [&] { made = true; });
    QVERIFY(made);
}

void tst_AcrossThreads::whoWaitsSeesWhatWasDone() {
    const Elsewhere<QObject> there;
    std::vector<int> numbers;
    auto count = [&] {
        for (int i = 0; i < 100; ++i)
            numbers.push_back(i);
    };
    for (int i = 0; i < 20; ++i)
        postAndWait(there.object.get(), count);
    QCOMPARE(numbers.size(), std::size_t(2000));
}

void tst_AcrossThreads::aSignalArrivesWithCopiesOfItsArguments() {
    const Elsewhere<Speaker> there;
    Hearer hearer;
    int silences = 0;
    connectAcross(there.object.get(), &Speaker::spoke, &hearer, &Hearer::hear);
    connectAcross(there.object.get(), &Speaker::fellSilent, &hearer, [&] { ++silences; });
    post(there.object.get(), [speaker = there.object.get()] {
        for (int i = 0; i < 100; ++i) {
            std::string words = "a sentence that is too long to be kept in the string itself";
            emit speaker->spoke(words, i);
            words.assign("overwritten");
        }
        emit speaker->fellSilent();
    });
    QTRY_COMPARE(silences, 1);
    QCOMPARE(hearer.heard.size(), std::size_t(100));
    QCOMPARE(hearer.heard[7], std::string("a sentence that is too long to be kept in the string itself 7"));
    QVERIFY(hearer.in_own_thread);
}

void tst_AcrossThreads::aSignalCanBePassedOn() {
    const Elsewhere<Speaker> there;
    Hearer hearer;
    std::string last;
    connectAcross(there.object.get(), &Speaker::spoke, &hearer, &Hearer::passedOn);
    QObject::connect(&hearer, &Hearer::passedOn, this, [&](const std::string& words, int) { last = words; });
    post(there.object.get(), [speaker = there.object.get()] { emit speaker->spoke("hello", 1); });
    QTRY_COMPARE(last, std::string("hello"));
}

void tst_AcrossThreads::whatIsUnderWayIsLostWithItsReceiver() {
    const Elsewhere<Speaker> there;
    int heard = 0;
    {
        QObject receiver;
        connectAcross(there.object.get(), &Speaker::fellSilent, &receiver, [&] { ++heard; });
        auto speak = [&] { emit there.object->fellSilent(); };
        postAndWait(there.object.get(), speak); // it waits in the event loop of this thread
    }
    auto speak = [&] { emit there.object->fellSilent(); };
    postAndWait(there.object.get(), speak); // nobody is connected any more
    usar::test::turnEventLoop();
    QCOMPARE(heard, 0);
}

USAR_TEST(tst_AcrossThreads)

} // namespace tst_across_threads

#include "tst_across_threads.moc"
