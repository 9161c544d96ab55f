#include "runtime/shadow/shadow_worker.h"

#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <iterator>
#include <list>
#include <mutex>
#include <new>
#include <thread>

#include "runtime/core/assertion.h"
#include "runtime/core/log.h"
#include "runtime/core/mailbox.h"
#include "runtime/core/start_thread.h"
#include "runtime/shadow/shadow_replica.h"
#include "runtime/shadow/shadow_step.h"

namespace rubble {

struct ShadowWorker::Impl {
    /// State of both threads, under the mutex.
    struct Shared {
        std::list<ShadowPatches> published;  ///< not yet taken
        uint64_t publishedVersion = 0;
        uint64_t queuedVersion = 0;     ///< the newest step in the queue
        uint64_t submittedVersion = 0;  ///< steps after queuedVersion change nothing
        uint64_t epoch = 0;
        uint64_t version() const { return publishedVersion == queuedVersion ? submittedVersion : publishedVersion; }
    };

    /// A step with the place for its publication: publishing takes no memory, so that it cannot fail.
    struct Work {
        ShadowStep step;
        std::list<ShadowPatches> place{1};
    };

    /// [worker] Makes one publication for this step and all others in the queue. Throws nothing.
    void work(Work&& first) {
        std::list<ShadowPatches> place = std::move(first.place);
        ShadowPatches& publication = place.front();
        std::optional<Work> next = std::move(first);
        uint64_t epoch = 0;
        while (next && !stop) {
            ShadowStep& step = next->step;
            publication.version = step.version;
            publication.replacesAll = publication.replacesAll || step.replacesAll;
            epoch = step.epoch;
            update([&] { replica.apply(std::move(step), mustStop); }, publication, step.replacesAll);
            next = queue.tryTake();
        }
        update([&] { replica.update(publication, mustStop); }, publication);
        if (stop) return;
        const std::lock_guard lock(mutex);
        if (epoch != shared.epoch) return;  // another level was loaded meanwhile: the next publication replaces all
        shared.publishedVersion = publication.version;
        shared.published.splice(shared.published.end(), place);
        changed.notify_all();
    }

    /// [worker] Works on the replica. Where an error ends that, the volume stays as it was last published, and the
    /// steps after it change nothing until one replaces all.
    template <class F>
    void update(F&& work, ShadowPatches& publication, bool replacesAll = false) {
        if (replacesAll) hasFailed = false;
        if (hasFailed) return;
        try {
            work();
        } catch (const std::bad_alloc&) {
            fail(publication, "out of memory");
        } catch (const std::exception& error) {
            fail(publication, error.what());
        }
    }
    void fail(ShadowPatches& publication, const char* reason) {
        hasFailed = true;
        replica = ShadowReplica();
        publication.patches.clear();
        logFailure(reason);
    }
    /// [worker] Takes no memory itself: there may be none.
    static void logFailure(const char* reason) {
        char text[512];
        std::snprintf(text, sizeof text, "shadow volume: %s; shadows stay as they are until another level is loaded",
                      reason);
        logError(text);
    }

    mutable std::mutex mutex;
    std::condition_variable changed;
    Shared shared;
    Mailbox<Work> queue;
    std::atomic<bool> stop = false;
    std::function<void()> onProgress;  ///< [worker] empty: nobody asks
    const ShadowReplica::MustStop mustStop = [this] {
        if (onProgress) onProgress();
        return stop.load();
    };
    ShadowReplica replica;   ///< [worker]
    bool hasFailed = false;  ///< [worker]
    uint64_t lag = 0;        ///< [main-thread]
    std::thread thread;      ///< none if inline
};

ShadowWorker::ShadowWorker(Mode mode, std::function<void()> onProgress) : m_impl(std::make_unique<Impl>()) {
    m_impl->onProgress = std::move(onProgress);
    if (mode == Mode::Inline) return;
    m_impl->thread = startThread([impl = m_impl.get()] {
        while (auto next = impl->queue.take()) impl->work(std::move(*next));
    });
}

ShadowWorker::~ShadowWorker() {
    m_impl->stop = true;
    m_impl->queue.close();
    if (m_impl->thread.joinable()) m_impl->thread.join();
}

void ShadowWorker::submit(const FrameChanges& changes, std::span<const BodyPose> moved, const World& world) {
    const bool isQueued = changesShadow(changes, moved);
    std::optional<Impl::Work> work;
    if (isQueued) work = Impl::Work{.step = makeShadowStep(changes, moved, world)};
    {
        const std::lock_guard lock(m_impl->mutex);
        Impl::Shared& shared = m_impl->shared;
        if (changes.levelReplaced) {
            ++shared.epoch;
            shared.published.clear();
            shared.publishedVersion = changes.step - 1;
        }
        if (isQueued) {
            shared.publishedVersion = shared.version();  // the steps since then have changed nothing
            shared.queuedVersion = changes.step;
        }
        shared.submittedVersion = changes.step;
        if (work) work->step.epoch = shared.epoch;
    }
    if (isQueued && m_impl->thread.joinable())
        m_impl->queue.post(std::move(*work));
    else if (isQueued)
        m_impl->work(std::move(*work));
    m_impl->lag = changes.step - publishedVersion();
}

std::vector<ShadowPatches> ShadowWorker::takePatches() {
    std::list<ShadowPatches> taken;
    {
        const std::lock_guard lock(m_impl->mutex);
        taken.swap(m_impl->shared.published);
    }
    return {std::make_move_iterator(taken.begin()), std::make_move_iterator(taken.end())};
}

void ShadowWorker::waitFor(uint64_t version) {
    std::unique_lock lock(m_impl->mutex);
    RUBBLE_ASSERT(version <= m_impl->shared.submittedVersion && "waiting for a step that was never submitted");
    m_impl->changed.wait(lock, [&] { return m_impl->shared.version() >= version; });
}

uint64_t ShadowWorker::publishedVersion() const {
    const std::lock_guard lock(m_impl->mutex);
    return m_impl->shared.version();
}

uint64_t ShadowWorker::lag() const {
    return m_impl->lag;
}

}  // namespace rubble
