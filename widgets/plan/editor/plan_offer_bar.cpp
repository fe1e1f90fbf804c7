#include "widgets/plan/editor/plan_offer_bar.h"

#include <utility>

#include "widgets/plan/plan_parts.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

PlanOfferBar::PlanOfferBar(QWidget* parent) : QFrame(parent) {
    setProperty("role", "card");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(gap::small, gap::tiny, gap::small, gap::tiny);
    words_ = makeLabel(this);
    row->addWidget(words_, 1);
    accept_ = makeToolButton(tr("Accept"), this);
    accept_->setAutoRaise(false);
    connect(accept_, &QToolButton::clicked, this, [this] {
        hide();
        if (const auto run = std::exchange(run_, nullptr))
            run();
    });
    row->addWidget(accept_);
    auto* no = makeToolButton(tr("Dismiss"), this, QStringLiteral("clear"));
    connect(no, &QToolButton::clicked, this, &QWidget::hide);
    row->addWidget(no);
    hide();
}

void PlanOfferBar::offer(const QString& words, const QString& accept, std::function<void()> run) {
    words_->setText(words);
    accept_->setText(accept);
    accept_->setAccessibleName(accept);
    run_ = std::move(run);
    show();
}

} // namespace usar::widgets
