# SPDX-License-Identifier: GPL-3.0-or-later
"""The workers of ``python3 -m stickslip.batch``."""

from __future__ import annotations

import importlib
import logging
import os
import shutil
import signal
import tempfile
import threading
import time
from typing import Any, Optional

from . import batch_chunk
from .errors import InputError


class Cluster:
    """Workers: those of a scheduler, or of this machine."""

    def __init__(self, scheduler: str, workers: int) -> None:
        try:
            dask: Any = importlib.import_module("dask")
            distributed: Any = importlib.import_module("distributed")
        except ImportError as error:
            raise InputError("", "", f"Dask distributed cannot be imported: {error}",
                             "install it (Debian: python3-distributed), or use stickslip batch on this "
                             "machine") from None
        logging.disable(logging.CRITICAL)  # what matters is said in our words
        self._distributed = distributed
        self._folder = ""
        self._local = None
        self.name = scheduler
        if not scheduler:
            self._folder = tempfile.mkdtemp(prefix="stickslip-batch-")
            os.environ["DASK_LOGGING__DISTRIBUTED"] = "critical"  # read by workers
            # A chunk that has cost one life is decided alone the next time; and what a worker had
            # when it died is not waited for half a minute.
            dask.config.set({"distributed.scheduler.allowed-failures": 0,
                             "distributed.comm.timeouts.connect": "10s",
                             "distributed.worker.profile.enabled": False})
            try:
                self._local = distributed.LocalCluster(
                    n_workers=workers or len(os.sched_getaffinity(0)), threads_per_worker=1,
                    processes=True, dashboard_address=":0", local_directory=self._folder,
                    preload=batch_chunk.__name__, silence_logs=logging.CRITICAL + 1)
            except BaseException:
                self._remove_folder()
                raise
        try:
            if scheduler:
                distributed.comm.resolve_address(scheduler)  # Client fails as well, but not silently
            self.client = distributed.Client(self._local or scheduler, set_as_default=False)
        except (OSError, ValueError) as error:
            reason = str(error).splitlines()[0] if str(error) else "no answer"
            raise InputError(scheduler, "--scheduler", f"there is no scheduler to talk to: {reason}",
                             "give the address that dask-scheduler prints, as tcp://node1:8786"
                             ) from None

    def threads(self) -> int:
        """Of all workers; 0 if there are none."""
        workers = self.client.scheduler_info()["workers"].values()
        return sum(worker["nthreads"] for worker in workers)

    def missing(self) -> str:
        """What is waited for while there are no threads. A client that has lost its scheduler knows
        of no worker either."""
        if self.client.status == "running":
            return "there is no worker; waiting for one to join"
        return "the scheduler does not answer; waiting for it to come back"

    def is_connected(self) -> bool:
        """Waits for a scheduler that is gone, as long as Dask does. False if it does not come."""
        while self.client.status == "connecting":
            time.sleep(0.1)
        return bool(self.client.status == "running")

    def died(self, error: Optional[BaseException]) -> bool:
        """The worker that had it, and those that had it before."""
        return isinstance(error, self._distributed.scheduler.KilledWorker)

    def close(self) -> None:
        """Workers that are deciding something do not end it."""
        self.client.close()
        if self._local is not None:
            closing = threading.Thread(target=self._local.close, daemon=True)
            closing.start()
            while closing.is_alive():
                closing.join(0.3)
                for nanny in self._local.workers.values():
                    if closing.is_alive() and nanny.pid:
                        os.kill(nanny.pid, signal.SIGKILL)
        self._remove_folder()

    def _remove_folder(self) -> None:
        if self._folder:
            shutil.rmtree(self._folder, ignore_errors=True)
