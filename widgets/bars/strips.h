// Strips above the map: the first steps of a new user, the progress of a long operation, and a question that does not
// stand in the way.
#pragma once

#include <functional>
#include <vector>

#include <QFrame>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>

#include "core/base/clock.h"
#include "widgets/models/first_steps.h"

namespace usar::widgets {

/// Shows each step with its number, or with a tick once it is done. When all are done it says once what comes next, and
/// goes. It can be dismissed at any time; its owner remembers that. GUI thread.
class HintStrip : public QFrame {
    Q_OBJECT
public:
    explicit HintStrip(QWidget* parent = nullptr);

    static QString textOf(FirstStep step);
    /// The step stays done.
    void setDone(FirstStep step);
    /// False: the step of the area is left out.
    void setAreaNeeded(bool needed);
    /// Sentences for the time after the last step.
    void setWhatNext(const QString& text);
    /// Offers a tour of the window, if there is room for the offer.
    void setTourOffered(bool offered);
    /// The offer needs no room.
    QSize minimumSizeHint() const override;
    /// In a replay there is nothing to start, so the strip is hidden as long as that.
    void setInReplay(bool in_replay);
    /// True once it need not be shown at the next start.
    bool dismissed() const { return dismissed_ || steps_.complete(); }
    void setDismissed(bool dismissed);

signals:
    /// The user wants the tour.
    void tourRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /// Shows the offer, if there is one and room for it.
    void fitTour();
    /// Renders the text from steps and state.
    void refresh();
    /// The steps as rich text.
    QString stepsText() const;

    FirstSteps steps_;
    QString what_next_;
    bool dismissed_ = false;
    bool in_replay_ = false;
    bool tour_offered_ = false;
    QLabel* text_ = new QLabel(this);
    QPushButton* tour_ = new QPushButton(tr("Take the tour"), this);
    QTimer* read_ = new QTimer(this); ///< dismisses the strip when there was time to read what comes next
};

/// Asks without a dialog: everything else goes on and can be used, the stop above all. GUI thread.
class QuestionStrip : public QFrame {
    Q_OBJECT
public:
    struct Answer {
        QString text;
        std::function<void()> run; ///< may be empty
    };

    explicit QuestionStrip(QWidget* parent = nullptr);

    /// Shows the question with a button for each answer, in place of the one before. The last answer changes nothing:
    /// it is given by itself after `patience`, which the strip counts down. `id` tells questions apart.
    void ask(const QString& id, const QString& question, std::vector<Answer> answers,
             std::chrono::seconds patience = std::chrono::seconds(20));
    /// Id of the question that is open; empty: none.
    const QString& openQuestion() const { return id_; }
    /// Gives the answer with this index, counted from 0, if a question is open.
    void give(std::size_t answer);

signals:
    /// An answer was given, and no question is open any more.
    void freed();

private:
    void countDown();

    QString id_;
    std::vector<Answer> answers_;
    int seconds_left_ = 0;
    QLabel* text_ = new QLabel(this);
    std::vector<QPushButton*> buttons_;
    QTimer second_;
};

/// Visible only while an operation takes longer than a moment. GUI thread.
class ProgressStrip : public QFrame {
    Q_OBJECT
public:
    explicit ProgressStrip(QWidget* parent = nullptr);

    /// Starts with a name such as "Opening run.usarsnap"; the progress is unknown until setProgress is called.
    void begin(const QString& what);
    /// Progress in simulated time.
    void setProgress(Seconds done, Seconds whole);
    /// Hides the strip.
    void end();

signals:
    /// The user wants to cancel; the strip stays until end().
    void cancelRequested();

private:
    QString what_;
    QLabel* text_ = new QLabel;
    QProgressBar* bar_ = new QProgressBar;
    QPushButton* cancel_ = new QPushButton(tr("Cancel"));
    QTimer soon_; ///< delays the strip, so that short operations do not show it
};

} // namespace usar::widgets
