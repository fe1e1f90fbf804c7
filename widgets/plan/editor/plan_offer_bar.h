// Bar for a question that needs no immediate answer.
#pragma once

#include <functional>

#include <QFrame>
#include <QLabel>
#include <QToolButton>

namespace usar::widgets {

/// Stays visible until the question is answered; hidden at first. GUI thread.
class PlanOfferBar : public QFrame {
    Q_OBJECT
public:
    explicit PlanOfferBar(QWidget* parent = nullptr);

    /// Asks a question in place of the last one; calls `run` if the user accepts.
    void offer(const QString& words, const QString& accept, std::function<void()> run);

private:
    QLabel* words_;
    QToolButton* accept_;
    std::function<void()> run_;
};

} // namespace usar::widgets
