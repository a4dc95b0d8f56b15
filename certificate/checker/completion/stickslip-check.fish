# fish completion for stickslip-check
# SPDX-License-Identifier: MIT
complete -c stickslip-check -l wrench -x -d 'Wrench applied to the object'
complete -c stickslip-check -l torque -x -d 'Short for --wrench 0,0,T'
complete -c stickslip-check -l case -x -d 'Case of the grasp file whose wrench is asked about'
complete -c stickslip-check -l direction -x -d 'Ask for the margin in this direction'
complete -c stickslip-check -l preload -x -d 'One preload for all contacts'
complete -c stickslip-check -l normal-law -x -a 'unilateral bilateral' -d 'Normal force of a contact'
complete -c stickslip-check -l preload-direction -x -a 'scale' -d 'Ask for the margin along preloads'
complete -c stickslip-check -l inertia -x -d 'Ask for the class of rigid contacts'
complete -c stickslip-check -l plane -x -d 'Ask for the region of this plane'
complete -c stickslip-check -l uncertain -x -d 'Ask about every grasp in a box'
complete -c stickslip-check -l json -d 'Answer as one JSON object'
complete -c stickslip-check -s h -l help -d 'Print a short help'
