"""Ending work: by a progress function and by signals; and that nothing is lost by it."""
import gc
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import weakref

from shapes import many_boxes
from sightline import Cancelled, Scene, hidden_lines


class Mine(Exception):
    pass


def all_work():
    """Names, and functions that take a progress function."""
    vertices, faces = many_boxes(40)
    scene = Scene(vertices, faces)
    prepared = scene.prepare(hidden=True)
    folder = tempfile.TemporaryDirectory()
    path = os.path.join(folder.name, "boxes.off")
    with open(path, "w") as file:
        file.write(f"OFF\n{len(vertices)} {len(faces)} 0\n")
        file.writelines(" ".join(map(str, v)) + "\n" for v in vertices.tolist())
        file.writelines("4 " + " ".join(map(str, f)) + "\n" for f in faces.tolist())
    return folder, {
        "Scene": lambda progress: Scene(vertices, faces, progress=progress),
        "Scene.load": lambda progress: Scene.load(path, progress=progress),
        "draw": lambda progress: scene.draw(hidden=True, progress=progress),
        "draw with threads": lambda progress: scene.draw(hidden=True, jobs=3, progress=progress),
        "prepare": lambda progress: scene.prepare(progress=progress),
        "Prepared.draw": lambda progress: prepared.draw(progress=progress),
        "hidden_lines": lambda progress: hidden_lines(vertices, faces, hidden=True, progress=progress),
    }


class Progress(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder, cls.work = all_work()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_it_rises_from_0_to_1(self):
        for name, work in self.work.items():
            done = []
            work(done.append)
            self.assertGreater(len(done), 1, name)
            self.assertEqual(done, sorted(done), name)
            self.assertTrue(0 <= done[0] and 0.9 <= done[-1] <= 1, name)

    def test_the_work_ends_at_any_call_that_returns_false(self):
        for name, work in self.work.items():
            calls = []
            work(calls.append)
            for stop in range(len(calls)):
                if name == "draw with threads" and stop > 3:
                    break  # the number of calls is not the same each time
                seen = []

                def progress(done):
                    seen.append(done)
                    return len(seen) <= stop

                with self.assertRaises(Cancelled) as caught:
                    work(progress)
                self.assertEqual(len(seen), stop + 1, f"{name}: a call after the last one")
                self.assertRegex(str(caught.exception), "^(.*boxes.off: )?cancelled$")
                self.assertEqual(caught.exception.kind, "cancelled")

    def test_what_it_raises_comes_out_unchanged_at_any_call(self):
        for name, work in self.work.items():
            calls = []
            work(calls.append)
            for stop in range(len(calls)):
                if name == "draw with threads" and stop > 3:
                    break
                seen = []
                raised = Mine(name, stop)

                def progress(done):
                    seen.append(done)
                    if len(seen) > stop:
                        raise raised

                with self.assertRaises(Mine) as caught:
                    work(progress)
                self.assertIs(caught.exception, raised)
                self.assertEqual(len(seen), stop + 1, f"{name}: a call after the last one")

    def test_other_results_are_tested_for_truth(self):
        work = self.work["draw"]
        expected = work(None).file()
        for result in (None, True, 1, "on"):
            self.assertEqual(work(lambda done: result).file(), expected)
        for result in (False, 0, ""):
            with self.assertRaises(Cancelled):
                work(lambda done: result)

        class Neither:
            def __bool__(self):
                raise Mine

        with self.assertRaises(Mine):
            work(lambda done: Neither())

    def test_it_may_draw_itself(self):
        scene = Scene(*many_boxes(3))
        expected = scene.draw("iso").file()
        files = []

        def outer(done):
            with self.assertRaises(Cancelled):
                scene.draw("iso", progress=lambda done: False)
            files.append(scene.draw("iso").file())

        self.assertEqual(scene.draw("iso", progress=outer).file(), expected)
        self.assertEqual(set(files), {expected})

    def test_of_two_threads_each_has_its_own(self):
        scene = Scene(*many_boxes(20))
        both = threading.Barrier(2, timeout=60)
        threads_seen = {}

        def run(cancel):
            met = []

            def progress(done):
                threads_seen.setdefault(cancel, set()).add(threading.get_ident())
                if not met:
                    met.append(both.wait())
                return not cancel

            try:
                scene.draw(progress=progress)
                outcomes[cancel] = "drawn"
            except Cancelled:
                outcomes[cancel] = "cancelled"

        outcomes = {}
        threads = [threading.Thread(target=run, args=(cancel,)) for cancel in (True, False)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(outcomes, {True: "cancelled", False: "drawn"})
        self.assertEqual([len(seen) for seen in threads_seen.values()], [1, 1])


class Signals(unittest.TestCase):
    # About a second of work in a release build.
    scene = None

    @classmethod
    def setUpClass(cls):
        cls.scene = Scene(*many_boxes(150))

    def test_they_are_handled_during_the_work_and_end_it_if_their_handler_raises(self):
        # Each signal is sent after the last one was handled. After the work at most one could still be handled.
        handled = threading.Semaphore(0)
        count = 0

        def handler(number, frame):
            nonlocal count
            count += 1
            handled.release()
            if count == 3:
                raise Mine

        def send():
            for _ in range(3):
                os.kill(os.getpid(), signal.SIGUSR1)
                handled.acquire(timeout=60)

        before = signal.signal(signal.SIGUSR1, handler)
        try:
            thread = threading.Thread(target=send)
            with self.assertRaises(Mine):
                thread.start()
                self.scene.draw(hidden=True)
            thread.join()
        finally:
            signal.signal(signal.SIGUSR1, before)
        self.assertEqual(count, 3)

    def test_ctrl_c_ends_a_program(self):
        program = """
import sightline
from shapes import many_boxes
scene = sightline.Scene(*many_boxes(50))
print("ready", flush=True)
while True:
    scene.draw(hidden=True)
"""
        with subprocess.Popen(
            [sys.executable, "-c", program],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            cwd=os.path.dirname(os.path.abspath(__file__)),
        ) as child:
            self.assertEqual(child.stdout.readline(), "ready\n")
            child.send_signal(signal.SIGINT)
            _, errors = child.communicate(timeout=60)
        self.assertEqual(child.returncode, -signal.SIGINT)
        self.assertEqual(errors.splitlines()[-1], "KeyboardInterrupt")

    def test_other_threads_run_during_the_work(self):
        ticks = 0
        stop = False

        def tick():
            nonlocal ticks
            while not stop:
                time.sleep(0.001)
                ticks += 1

        thread = threading.Thread(target=tick)
        thread.start()
        try:
            before = ticks
            self.scene.draw(hidden=True)
            during = ticks - before
        finally:
            stop = True
            thread.join()
        self.assertGreater(during, 10)


class Memory(unittest.TestCase):
    @staticmethod
    def resident():
        with open("/proc/self/statm") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    def test_nothing_refers_to_a_progress_function_after_its_call(self):
        folder, work = all_work()
        self.addCleanup(folder.cleanup)
        for name, function in work.items():
            for answer in (True, False, Mine):

                def progress(done, answer=answer):
                    if answer is Mine:
                        raise Mine
                    return answer

                before = sys.getrefcount(progress)
                try:
                    result = function(progress)
                except (Cancelled, Mine):
                    result = None
                self.assertEqual(sys.getrefcount(progress), before, (name, answer))
                reference = weakref.ref(progress)
                del progress
                gc.collect()
                self.assertIsNone(reference(), (name, answer))
                del result

    def test_memory_does_not_grow(self):
        # Without any release the results of 10 rounds would need 100 MB and more.
        folder, work = all_work()
        self.addCleanup(folder.cleanup)

        def one_round():
            for function in work.values():
                function(None)
                for answer in (False, Mine()):

                    def progress(done):
                        if isinstance(answer, Mine) and done > 0.3:
                            raise answer
                        return not (answer is False and done > 0.3)

                    try:
                        function(progress)
                    except (Cancelled, Mine):
                        pass
            work["draw"](None).svg()
            try:
                Scene([(0, 0, 0)], [(0, 1, 2)])
            except ValueError:
                pass

        for _ in range(5):
            one_round()
        gc.collect()
        before = self.resident()
        for _ in range(10):
            one_round()
        gc.collect()
        self.assertLess(self.resident() - before, 30e6)


if __name__ == "__main__":
    unittest.main()
